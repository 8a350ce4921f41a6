#include "pmts/simulator/line_framing.hpp"

#include <QRegularExpression>

#include <bit>
#include <vector>

namespace pmts::simulator {
namespace {

constexpr int kLeastBaud = 50;  ///< the slowest that a serial port knows
constexpr int kMostBaud = 115200;

bool hasOddOnes(unsigned value) { return std::popcount(value) % 2 == 1; }

bool parityBit(unsigned value, WireParity parity) { return hasOddOnes(value) == (parity == WireParity::kEven); }

/// The wire as the sender drives it, one entry a bit, true: mark (idle).
std::vector<bool> levelsOf(std::string_view bytes, const LineFraming& line) {
    std::vector<bool> levels{true};  // it was idle before
    for (const char byte : bytes) {
        const unsigned value = static_cast<unsigned char>(byte) & ((1U << line.data_bits) - 1U);
        levels.push_back(false);
        for (int bit = 0; bit < line.data_bits; ++bit) {
            levels.push_back(((value >> bit) & 1U) != 0);
        }
        if (line.parity != WireParity::kNone) {
            levels.push_back(parityBit(value, line.parity));
        }
        levels.insert(levels.end(), static_cast<std::size_t>(line.stop_bits), true);
    }
    return levels;
}

/// A receiver that looks at the wire in bits of its own length.
class Receiver {
public:
    Receiver(std::vector<bool> levels, double sender_bits_per_bit, const LineFraming& line)
        : levels_(std::move(levels)), step_(sender_bits_per_bit), line_(line) {}

    std::string read() {
        std::string heard;
        while (findStart()) {
            readByte(heard);
        }
        return heard;
    }

private:
    [[nodiscard]] bool levelAt(double place) const {
        const auto index = static_cast<std::size_t>(place);
        return index >= levels_.size() || levels_[index];
    }

    /// The next edge from mark to space.
    bool findStart() {
        const auto size = static_cast<double>(levels_.size());
        while (at_ < size && !levelAt(at_)) {
            at_ = nextEdge();
        }
        while (at_ < size && levelAt(at_)) {
            at_ = nextEdge();
        }
        return at_ < size;
    }
    [[nodiscard]] double nextEdge() const { return static_cast<double>(static_cast<std::size_t>(at_) + 1); }

    void readByte(std::string& heard) {
        constexpr double kMiddle = 0.5;
        if (levelAt(at_ + kMiddle * step_)) {
            at_ = nextEdge();  // a spike, no start bit
            return;
        }
        unsigned value = 0;
        double place = at_ + (1.0 + kMiddle) * step_;
        for (int bit = 0; bit < line_.data_bits; ++bit, place += step_) {
            value |= (levelAt(place) ? 1U : 0U) << bit;
        }
        bool good = true;
        if (line_.parity != WireParity::kNone) {
            good = levelAt(place) == parityBit(value, line_.parity);
            place += step_;
        }
        good = good && levelAt(place);
        at_ = place;  // the middle of the stop bit: a new start may follow
        if (good) {
            heard += static_cast<char>(value);
        }
    }

    std::vector<bool> levels_;
    double step_;
    LineFraming line_;
    double at_ = 0.0;  ///< in bits of the sender
};

}  // namespace

QString LineFraming::text() const {
    const QChar letter = parity == WireParity::kNone ? u'N' : parity == WireParity::kOdd ? u'O' : u'E';
    return QStringLiteral("%1-%2%3%4").arg(baud).arg(data_bits).arg(letter).arg(stop_bits);
}

std::optional<LineFraming> LineFraming::fromText(const QString& text) {
    static const QRegularExpression form(QStringLiteral("^([0-9]{2,6})-([78])([NOE])([12])$"));
    const auto match = form.match(text.toUpper());
    const int baud = match.captured(1).toInt();
    if (!match.hasMatch() || baud < kLeastBaud || baud > kMostBaud) {
        return std::nullopt;
    }
    const QChar letter = match.captured(3).front();
    return LineFraming{.baud = baud,
                       .data_bits = match.captured(2).toInt(),
                       .parity = letter == u'N'   ? WireParity::kNone
                                 : letter == u'O' ? WireParity::kOdd
                                                  : WireParity::kEven,
                       .stop_bits = match.captured(4).toInt()};
}

std::string heardAs(std::string_view bytes, const LineFraming& sent, const LineFraming& heard) {
    if (sent == heard) {
        return std::string(bytes);
    }
    return Receiver(levelsOf(bytes, sent), static_cast<double>(sent.baud) / heard.baud, heard).read();
}

}  // namespace pmts::simulator
