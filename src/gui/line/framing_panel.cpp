#include "framing_panel.hpp"

#include "parts/lab_parts.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QSignalBlocker>

namespace pmts::gui {
namespace {

constexpr int kField_px = 34;
constexpr double kFastest_baud = 1e8;

/// Short, because the list is narrow: `0.98: 9600 8N1, least first, rests high`.
QString scoreText(const app::LineFindings& findings, const protocol::FramingScore& score) {
    const protocol::Framing& framing = score.framing;
    const auto baud = findings.baudOf(framing);
    const QString pace = baud ? QString::number(*baud, 'f', 0) : FramingPanel::tr("%1 a bit").arg(framing.samples_per_bit, 0, 'f', 2);
    return QStringLiteral("%1: %2 %3, %4, %5")
        .arg(score.score, 0, 'f', 2)
        .arg(pace, framing.text(), framing.least_significant_first ? FramingPanel::tr("least first") : FramingPanel::tr("most first"),
             framing.idle_high ? FramingPanel::tr("rests high") : FramingPanel::tr("rests low"));
}

}  // namespace

FramingPanel::FramingPanel(app::LineBenchPresenter& bench, QWidget* parent)
    : QWidget(parent),
      bench_(bench),
      title_(labHeading(QString(), this)),
      scores_(new QComboBox(this)),
      pace_(new QDoubleSpinBox(this)),
      pace_label_(new QLabel(this)),
      decoded_(new QCheckBox(tr("Decode this pin"), this)) {
    scores_->setObjectName(QStringLiteral("bench_scores"));
    scores_->setAccessibleName(tr("Framings that were found, with their score"));
    scores_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    scores_->setMinimumHeight(kField_px);
    pace_->setObjectName(QStringLiteral("bench_pace"));
    pace_->setRange(1.0, kFastest_baud);
    pace_->setKeyboardTracking(false);
    pace_->setMinimumHeight(kField_px);
    decoded_->setObjectName(QStringLiteral("bench_decode_pin"));
    decoded_->setMinimumHeight(kField_px);
    bits_ = choice("bench_bits", tr("Data bits"), {tr("8 bits"), tr("7 bits")});
    parity_ = choice("bench_parity", tr("Parity"), {tr("No parity"), tr("Even parity"), tr("Odd parity")});
    order_ = choice("bench_order", tr("Order of the bits"), {tr("Least bit first"), tr("Most bit first")});
    rest_ = choice("bench_rest", tr("Level of rest"), {tr("Rests high"), tr("Rests low")});
    way_ = choice("bench_way", tr("Way of the bytes"), {tr("Way not known"), tr("To the instrument"), tr("From the instrument")});
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    grid->addWidget(title_, 0, 0);
    grid->addWidget(decoded_, 0, 1);
    grid->addWidget(scores_, 1, 0, 1, 2);
    grid->addWidget(pace_label_, 2, 0);
    grid->addWidget(pace_, 2, 1);
    grid->addWidget(bits_, 3, 0);
    grid->addWidget(parity_, 3, 1);
    grid->addWidget(order_, 4, 0);
    grid->addWidget(rest_, 4, 1);
    grid->addWidget(way_, 5, 0, 1, 2);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    grid->setRowStretch(6, 1);
    connect(scores_, &QComboBox::activated, this, [this](int place) { bench_.useFound(line_, static_cast<std::size_t>(place)); });
    connect(pace_, &QDoubleSpinBox::valueChanged, this, &FramingPanel::take);
    for (QComboBox* box : {bits_, parity_, order_, rest_}) {
        connect(box, &QComboBox::activated, this, &FramingPanel::take);
    }
    connect(way_, &QComboBox::activated, this, [this](int way) { bench_.setSide(line_, static_cast<protocol::TalkSide>(way)); });
    connect(decoded_, &QCheckBox::clicked, this, [this](bool on) { bench_.setDecoded(line_, on); });
    connect(&bench_, &app::LineBenchPresenter::changed, this, &FramingPanel::fill);
    connect(&bench_, &app::LineBenchPresenter::busyChanged, this, &FramingPanel::fill);
    fill();
}

QComboBox* FramingPanel::choice(const char* name, const QString& label, const QStringList& texts) {
    auto* const box = new QComboBox(this);
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(label);
    box->setToolTip(label);
    box->setMinimumHeight(kField_px);
    box->addItems(texts);
    return box;
}

void FramingPanel::showLine(int line) {
    line_ = line;
    fill();
}

const app::FoundLine* FramingPanel::found() const {
    const auto& findings = bench_.findings();
    const bool known = findings && line_ >= 0 && static_cast<std::size_t>(line_) < findings->lines.size();
    return known ? &findings->lines[static_cast<std::size_t>(line_)] : nullptr;
}

void FramingPanel::fillFound(const app::FoundLine& line) {
    const QSignalBlocker quiet(scores_);
    scores_->clear();
    int place = -1;
    for (const protocol::FramingScore& score : line.scores) {
        if (line.framing && line.score() == score.score && place < 0) {
            place = scores_->count();
        }
        scores_->addItem(scoreText(*bench_.findings(), score));
        scores_->setItemData(scores_->count() - 1, app::framingWords(score.framing), Qt::ToolTipRole);
    }
    scores_->setPlaceholderText(line.scores.empty() ? tr("No framing was found") : tr("By hand"));
    scores_->setCurrentIndex(place);
}

void FramingPanel::fill() {
    const app::FoundLine* const line = found();
    for (QWidget* part : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        part->setEnabled(line != nullptr && !bench_.isBusy());
    }
    title_->setText(line == nullptr ? tr("No pin") : tr("Pin %1").arg(line_));
    if (line == nullptr) {
        return;
    }
    fillFound(*line);
    const auto framing = line->framing.value_or(protocol::Framing());
    const auto baud = bench_.findings()->baudOf(framing);
    const QSignalBlocker quiet(pace_);
    pace_label_->setText(baud ? tr("Baud") : tr("Samples a bit"));
    pace_->setDecimals(baud ? 0 : 2);
    pace_->setValue(baud.value_or(framing.samples_per_bit));
    bits_->setCurrentIndex(framing.data_bits == 8 ? 0 : 1);
    parity_->setCurrentIndex(static_cast<int>(framing.parity));
    order_->setCurrentIndex(framing.least_significant_first ? 0 : 1);
    rest_->setCurrentIndex(framing.idle_high ? 0 : 1);
    way_->setCurrentIndex(static_cast<int>(line->side));
    decoded_->setChecked(line->is_decoded);
}

void FramingPanel::take() {
    const app::FoundLine* const line = found();
    if (line == nullptr) {
        return;
    }
    const auto rate = bench_.findings()->recording->samples_per_s;
    protocol::Framing framing = line->framing.value_or(protocol::Framing());
    const double shown = bench_.findings()->baudOf(framing).value_or(framing.samples_per_bit);
    if (std::abs(pace_->value() - shown) > 0.51 * std::pow(10.0, -pace_->decimals())) {  // typed, not rounded
        framing.samples_per_bit = std::max(1.0, rate ? *rate / pace_->value() : pace_->value());
    }
    framing.data_bits = bits_->currentIndex() == 0 ? 8 : 7;
    framing.parity = static_cast<protocol::LineParity>(parity_->currentIndex());
    framing.least_significant_first = order_->currentIndex() == 0;
    framing.idle_high = rest_->currentIndex() == 0;
    bench_.setFraming(line_, framing);
}

}  // namespace pmts::gui
