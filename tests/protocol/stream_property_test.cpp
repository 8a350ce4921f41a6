#include "pmts/protocol/reply.hpp"
#include "pmts/protocol/units.hpp"

#include <random>

namespace pmts::protocol {

void PrintTo(const Reply& reply, std::ostream* out) {
    *out << (reply.status ? "status " + std::to_string(reply.status->code) : "no status")
         << (reply.damaged ? ", damaged" : "");
    for (const auto& item : reply.items) {
        *out << ", " << item.label.value_or(-1) << '=' << item.data;
    }
}

namespace {

/// A stream of the instrument as it may reach us, and what it says.
struct Stream {
    std::string bytes;
    std::vector<Reply> truth;
};

class StreamProperty : public testing::Test {
protected:
    /// Runs the property on many streams; a failure names its seed.
    template <class Property>
    void onEverySeed(Property property) {
        for (unsigned seed = 1; seed <= 200; ++seed) {
            SCOPED_TRACE(seed);
            random_.seed(seed);
            property();
        }
    }

    int roll(int below) { return std::uniform_int_distribution<int>(0, below - 1)(random_); }

    Reply randomReply() {
        Reply reply;
        if (roll(4) != 0) {
            reply.status = Status{roll(302), roll(2) == 0 ? std::nullopt : std::optional(roll(16))};
        }
        int label = 0;
        for (int i = roll(6); i > 0; --i) {
            label += 1 + roll(18);
            const auto angle = core::Angle::fromCc(roll(4'000'000));
            reply.items.push_back({label, "", wireAngle(angle, WireAngleUnit::kGon, 4)});
        }
        return reply;
    }

    static std::string textOf(const Reply& reply) {
        std::string text;
        if (reply.status) {
            text += std::to_string(reply.status->code);
            text += reply.status->suffix ? "." + std::to_string(*reply.status->suffix) + "\r\n" : "\r\n";
        }
        for (const auto& item : reply.items) {
            text += std::to_string(*item.label) + "=" + item.data + "\r\n";
        }
        return text;
    }

    /// Line noise that is certainly no text and no end mark.
    std::string noise() {
        static const std::string kNoise = std::string("\x00", 1) + "\x01\x7F\x80\xC3\xFE\xFF";
        std::string text;
        for (int i = roll(4); i > 0; --i) {
            text += kNoise[static_cast<std::size_t>(roll(static_cast<int>(kNoise.size())))];
        }
        return text;
    }

    Stream randomStream(char end_mark) {
        Stream stream;
        for (int i = 1 + roll(12); i > 0; --i) {
            Reply reply = randomReply();
            stream.bytes += (roll(3) == 0 ? noise() : "") + (roll(4) == 0 ? std::string(1, end_mark) : "");
            stream.bytes += (roll(3) == 0 ? noise() : "") + textOf(reply) + end_mark;
            stream.truth.push_back(std::move(reply));
        }
        return stream;
    }

    std::vector<std::string> feedInChunks(BlockReader& reader, std::string_view bytes) {
        std::vector<std::string> blocks;
        while (!bytes.empty()) {
            const auto size = std::min<std::size_t>(static_cast<std::size_t>(1 + roll(9)), bytes.size());
            for (auto& block : reader.feed(bytes.substr(0, size))) {
                blocks.push_back(std::move(block));
            }
            bytes.remove_prefix(size);
        }
        return blocks;
    }

    /// What a reader that waits for data sees: replies without content are passed over.
    static std::vector<Reply> contentOf(const std::vector<std::string>& blocks) {
        std::vector<Reply> replies;
        for (const auto& block : blocks) {
            Reply reply = parseReply(block, ReplyShape{});
            reply.raw.clear();
            if (reply.status || !reply.items.empty()) {
                replies.push_back(std::move(reply));
            }
        }
        return replies;
    }

    static std::vector<Reply> withContent(std::vector<Reply> replies) {
        std::erase_if(replies, [](const Reply& r) { return !r.status && r.items.empty(); });
        return replies;
    }

private:
    std::mt19937 random_;
};

TEST_F(StreamProperty, AnyChunkingStrayMarkAndNoiseGiveTheSameReplies) {
    onEverySeed([this] {
        const Stream stream = randomStream('>');
        BlockReader reader;
        const auto blocks = feedInChunks(reader, stream.bytes);
        EXPECT_EQ(contentOf(blocks), withContent(stream.truth));
        EXPECT_FALSE(reader.hasPending());
    });
}

TEST_F(StreamProperty, EndMarkMayChangeBetweenBlocks) {
    onEverySeed([this] {
        BlockReader reader;
        for (const char end_mark : {'>', '\x04', '#', '\x03'}) {
            reader.setEndMark(end_mark);
            const Stream stream = randomStream(end_mark);
            EXPECT_EQ(contentOf(feedInChunks(reader, stream.bytes)), withContent(stream.truth));
        }
    });
}

TEST_F(StreamProperty, WithoutEndMarkEachQuietTimeGivesOneReply) {
    onEverySeed([this] {
        BlockReader reader(std::nullopt);
        const Stream stream = randomStream('>');
        for (const Reply& truth : withContent(stream.truth)) {
            EXPECT_TRUE(feedInChunks(reader, textOf(truth)).empty());
            EXPECT_EQ(contentOf({reader.flush().value()}), std::vector{truth});
        }
    });
}

TEST_F(StreamProperty, ArbitraryBytesNeverBreakTheReader) {
    onEverySeed([this] {
        std::string bytes;
        for (int i = roll(400); i > 0; --i) {
            bytes += static_cast<char>(roll(256));
        }
        BlockReader reader;
        for (const auto& block : feedInChunks(reader, bytes)) {
            for (const bool separate : {false, true}) {
                const Reply reply = parseReply(block, separate);
                EXPECT_EQ(reply.raw, block);
                EXPECT_LE(reply.items.size(), block.size());
            }
        }
    });
}

}  // namespace
}  // namespace pmts::protocol
