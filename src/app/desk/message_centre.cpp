#include "pmts/app/desk/message_centre.hpp"

#include "pmts/instrument/control_settings.hpp"

#include <QCoreApplication>

#include <algorithm>

namespace pmts::app {

namespace {

QString detailsOf(const core::Error& error) {
    const QString code = error.info_code ? QStringLiteral("info %1").arg(*error.info_code) : QString();
    return code.isEmpty() || error.detail.isEmpty() ? code + error.detail : code + QStringLiteral(", ") + error.detail;
}

}  // namespace

QString actionText(MessageAction action) {
    const auto say = [](const char* text) { return QCoreApplication::translate("MessageCentre", text); };
    switch (action) {
        case MessageAction::kNone: return {};
        case MessageAction::kOpenConnectionPage: return say("Open connection page");
        case MessageAction::kOpenJob: return say("Choose a job");
        case MessageAction::kRetryRecord: return say("Record again");
        case MessageAction::kRecordSameId: return say("Record it all the same");
        case MessageAction::kShowLog: return say("Show log");
        case MessageAction::kOpenSettings: return say("Open settings");
        case MessageAction::kReconnect: return say("Connect again");
        case MessageAction::kAcceptBlock: return say("Record it");
        case MessageAction::kTurnWithoutPicture: return say("Turn without re-centring");
        case MessageAction::kTurnTheLongWay: return say("Turn the long way");
        case MessageAction::kCheckRig: return say("Check");
        case MessageAction::kTakeControl: return say("Take control back");
        case MessageAction::kOpenControlPage: return say("Open control page");
    }
    return {};
}

quint64 MessageCentre::toast(const QString& happened) {
    Message message;
    message.id = ++last_id_;
    message.happened = happened;
    Q_EMIT toastShown(message);
    return message.id;
}

quint64 MessageCentre::report(const core::Error& error, MessageAction action, const QString& topic) {
    Message message;
    message.kind = MessageKind::kProblem;
    message.happened = error.happened;
    message.remedy = error.remedy;
    message.details = detailsOf(error);
    message.action = action;
    message.topic = topic;
    if (instrument::isPanelControl(error)) {  // one bar and one way out, whoever was refused
        message.action = MessageAction::kTakeControl;
        message.topic = kControlTopic;
    }
    return keepBar(std::move(message));
}

quint64 MessageCentre::warn(const QString& happened, const QString& remedy, MessageAction action, const QString& topic) {
    Message message;
    message.kind = MessageKind::kWarning;
    message.happened = happened;
    message.remedy = remedy;
    message.action = action;
    message.topic = topic;
    return keepBar(std::move(message));
}

quint64 MessageCentre::keepBar(Message message) {
    message.id = ++last_id_;
    message.action_text = actionText(message.action);
    const auto same = std::find_if(bars_.begin(), bars_.end(), [&message](const Message& bar) {
        return message.topic.isEmpty() ? bar.topic.isEmpty() && bar.happened == message.happened
                                       : bar.topic == message.topic;
    });
    if (same == bars_.end()) {
        bars_.push_back(message);
    } else {
        message.count = same->happened == message.happened ? same->count + 1 : 1;
        *same = message;
    }
    Q_EMIT barKept(message);
    Q_EMIT barsChanged();
    return message.id;
}

void MessageCentre::solve(const QString& topic) {
    if (std::erase_if(bars_, [&topic](const Message& bar) { return bar.topic == topic; }) > 0) {
        Q_EMIT barsChanged();
    }
}

void MessageCentre::showBars(std::vector<Message> bars) {
    bars_ = std::move(bars);
    for (Message& bar : bars_) {
        bar.id = ++last_id_;
    }
    Q_EMIT barsChanged();
}

void MessageCentre::dismiss(quint64 id) {
    if (std::erase_if(bars_, [id](const Message& bar) { return bar.id == id; }) > 0) {
        Q_EMIT barsChanged();
    }
}

}  // namespace pmts::app
