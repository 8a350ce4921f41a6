#include "replay_bar.hpp"

#include "parts/lab_parts.hpp"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSlider>

#include <optional>

namespace pmts::gui {
namespace {

constexpr double kSpeeds[] = {0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 64.0};
constexpr double kSlowest = 0.1, kFastest = 1000.0;
constexpr int kSteps = 10000;

/// `3`, `0.5×`, `2,5 x`; absent when it is no speed.
std::optional<double> speedFrom(QString text) {
    static const QRegularExpression kTimes(QStringLiteral(R"([×xX\s]+$)"));
    bool is_number = false;
    const double speed = text.remove(kTimes).replace(u',', u'.').toDouble(&is_number);
    return is_number && speed >= kSlowest && speed <= kFastest ? std::optional(speed) : std::nullopt;
}

/// `1:02:07`
QString clockText(core::Duration span) {
    const auto s = std::chrono::duration_cast<std::chrono::seconds>(span).count();
    return QStringLiteral("%1:%2:%3").arg(s / 3600).arg(s / 60 % 60, 2, 10, QChar(u'0')).arg(s % 60, 2, 10, QChar(u'0'));
}

}  // namespace

ReplayBar::ReplayBar(app::ReplayPresenter& replay, QWidget* parent)
    : QToolBar(tr("Recording"), parent), replay_(replay), play_(labButton(tr("Pause"), "replay_play", this)),
      speed_(new QComboBox(this)), place_(new QSlider(Qt::Horizontal, this)), time_(new QLabel(this)), said_(new QLabel(this)) {
    setObjectName(QStringLiteral("replay_bar"));
    setMovable(false);
    auto* const all = new QWidget(this);
    auto* const row = new QHBoxLayout(all);
    row->setContentsMargins(6, 2, 6, 2);
    speed_->setObjectName(QStringLiteral("replay_speed"));
    speed_->setAccessibleName(tr("Speed of the recording"));
    speed_->setEditable(true);
    speed_->setInsertPolicy(QComboBox::NoInsert);
    speed_->setToolTip(tr("Choose a speed or type one, %1 to %2 times").arg(kSlowest).arg(kFastest));
    speed_->setMinimumHeight(ActionButton::kLeastSide_px);
    place_->setObjectName(QStringLiteral("replay_place"));
    place_->setAccessibleName(tr("Place in the recording"));
    place_->setRange(0, kSteps);
    place_->setPageStep(kSteps / 20);
    place_->setSingleStep(kSteps / 200);
    place_->setTracking(false);  // a jump builds five minutes anew: once, where it is let go
    place_->setMinimumHeight(ActionButton::kLeastSide_px);
    time_->setObjectName(QStringLiteral("replay_time"));
    said_->setObjectName(QStringLiteral("replay_said"));
    play_->setMinimumWidth(play_->fontMetrics().horizontalAdvance(tr("Pause") + tr("Play")));
    play_->setToolTip(tr("Play or pause (Ctrl+Space)"));
    row->addWidget(play_);
    row->addWidget(speed_);
    row->addWidget(place_, 1);
    row->addWidget(time_);
    row->addWidget(said_);
    addWidget(all);
    fillSpeeds();
    wire();
    showSentence(tr("The recording is being read…"));
    all->setEnabled(replay_.isOpen());
    connect(&replay_, &app::ReplayPresenter::opened, all, [this, all] {
        all->setEnabled(true);
        fillSpeeds();
        showSentence(replay_.damageText());
    });
}

void ReplayBar::fillSpeeds() {
    const QSignalBlocker quiet(speed_);
    speed_->clear();
    for (const double speed : kSpeeds) {
        speed_->addItem(tr("%1×").arg(speed), speed);
    }
    showSpeed();
}

void ReplayBar::showSpeed() {
    const QSignalBlocker quiet(speed_);
    speed_->setCurrentIndex(speed_->findData(replay_.speed()));
    speed_->setEditText(tr("%1×").arg(replay_.speed()));
}

/// What is no speed gives way to the one that is played with.
void ReplayBar::takeSpeed() {
    const auto speed = speedFrom(speed_->currentText());
    if (speed && *speed != replay_.speed()) {
        replay_.setSpeed(*speed);
    }
    showSpeed();
}

void ReplayBar::wire() {
    auto* const toggle = new QAction(tr("Play or pause"), this);
    toggle->setShortcut(Qt::CTRL | Qt::Key_Space);
    parentWidget()->addAction(toggle);
    const auto play_or_pause = [this] { replay_.isPlaying() ? replay_.pause() : replay_.play(); };
    connect(toggle, &QAction::triggered, this, play_or_pause);
    connect(play_, &QPushButton::clicked, this, play_or_pause);
    connect(speed_, &QComboBox::activated, this, &ReplayBar::takeSpeed);
    connect(speed_->lineEdit(), &QLineEdit::editingFinished, this, &ReplayBar::takeSpeed);
    connect(place_, &QSlider::valueChanged, this, [this](int step) {  // by hand: showMoment() is quiet
        replay_.seek(core::Duration(replay_.length().count() / kSteps * step));
    });
    connect(&replay_, &app::ReplayPresenter::moved, this, &ReplayBar::showMoment);
    connect(&replay_, &app::ReplayPresenter::playingChanged, this, &ReplayBar::showPlaying);
    connect(&replay_, &app::ReplayPresenter::failed, this, [this](const core::Error& error) { showSentence(error.sentence()); });
}

void ReplayBar::showMoment() {
    if (!place_->isSliderDown()) {
        const QSignalBlocker quiet(place_);
        const auto length = std::max<core::Duration::rep>(1, replay_.length().count());
        place_->setValue(static_cast<int>(static_cast<double>(replay_.position().count()) / static_cast<double>(length) * kSteps));
    }
    time_->setText(tr("%1 of %2, %3").arg(clockText(replay_.position()), clockText(replay_.length()),
                                          replay_.utc().toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss"))));
    showSentence(replay_.lastAction().isEmpty() ? replay_.damageText() : tr("Last done: %1").arg(replay_.lastAction()));
}

void ReplayBar::showPlaying(bool playing) { play_->setText(playing ? tr("Pause") : tr("Play")); }

void ReplayBar::showSentence(const QString& sentence) {
    constexpr int kWidest_px = 300;
    said_->setText(said_->fontMetrics().elidedText(sentence, Qt::ElideRight, kWidest_px));
    said_->setToolTip(sentence);
}

}  // namespace pmts::gui
