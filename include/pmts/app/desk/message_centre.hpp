#pragma once

#include "pmts/core/result.hpp"

#include <QObject>
#include <QString>

#include <vector>

namespace pmts::app {

/// What a button under a message does; the gui maps it to a page or a slot.
enum class MessageAction { kNone, kOpenConnectionPage, kOpenJob, kRetryRecord, kRecordSameId, kShowLog, kOpenSettings, kReconnect,
                           kAcceptBlock, kTurnWithoutPicture, kTurnTheLongWay, kCheckRig, kTakeControl, kOpenControlPage };

enum class MessageKind {
    kToast,    ///< good news, goes away by itself
    kWarning,  ///< a bar that stays until it is dismissed or solved
    kProblem,
};

/// Of every request that was refused because the panel has control.
inline constexpr QLatin1String kControlTopic("control");

/// Sounds, told apart without looking; played by the gui when the setting allows.
enum class Cue { kArrived, kRecorded, kFailed };

struct Message {
    quint64 id = 0;
    MessageKind kind = MessageKind::kToast;
    QString happened;  ///< one sentence
    QString remedy;    ///< one sentence, may be empty
    MessageAction action = MessageAction::kNone;
    QString action_text;  ///< `Open connection page`
    QString details;      ///< folded: device code, path
    QString topic;        ///< a new message of the same non-empty topic replaces the old one
    int count = 1;        ///< the same message again counts up instead of piling up
};

/// Where presenters say what happened. Bars stay until dismissed, replaced or solved by topic.
class MessageCentre : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    quint64 toast(const QString& happened);
    quint64 report(const core::Error& error, MessageAction action = MessageAction::kNone, const QString& topic = {});
    quint64 warn(const QString& happened, const QString& remedy, MessageAction action = MessageAction::kNone,
                 const QString& topic = {});
    /// Takes away the bars of a topic: the trouble is over.
    void solve(const QString& topic);
    void cue(Cue cue) { Q_EMIT cueGiven(cue); }
    [[nodiscard]] const std::vector<Message>& bars() const { return bars_; }
    void showBars(std::vector<Message> bars);  ///< of a recording, instead of those that stand

public Q_SLOTS:
    void dismiss(quint64 id);

Q_SIGNALS:
    void toastShown(const pmts::app::Message& message);
    void barsChanged();
    void barKept(const pmts::app::Message& message);  ///< a new or renewed bar, for the log
    void cueGiven(pmts::app::Cue cue);

private:
    quint64 keepBar(Message message);

    std::vector<Message> bars_;
    quint64 last_id_ = 0;
};

[[nodiscard]] QString actionText(MessageAction action);

}  // namespace pmts::app
