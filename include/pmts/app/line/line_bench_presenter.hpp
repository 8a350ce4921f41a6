#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/desk/message_centre.hpp"
#include "pmts/app/line/talk_model.hpp"
#include "pmts/app/desk/threading.hpp"
#include "pmts/app/line/variable_names.hpp"

#include <QFutureWatcher>
#include <QObject>

#include <functional>

namespace pmts::app {

/// The bench for unknown lines: a recording is read, its pins are classified, framings are found, text is decoded and
/// searched, compared with what a panel shows, and saved as an instruction table. Reading, decoding and comparing are
/// done in the pool, one at a time.
class LineBenchPresenter : public QObject {
    Q_OBJECT
public:
    LineBenchPresenter(MessageCentre& messages, const QString& data_folder, Threading threading = Threading::kOwnThread,
                       QObject* parent = nullptr);
    ~LineBenchPresenter() override;  ///< work under way is cancelled and waited for

    [[nodiscard]] bool isBusy() const { return !reason_.isEmpty(); }
    [[nodiscard]] const QString& reason() const { return reason_; }  ///< what is being done; empty: nothing
    [[nodiscard]] DeviceState state() const;
    /// Of the file that was last asked for, also when it could not be read; empty: none yet.
    [[nodiscard]] const QString& path() const { return path_; }
    [[nodiscard]] const std::shared_ptr<const LineFindings>& findings() const { return findings_; }
    [[nodiscard]] QString summary() const;       ///< what was found, one or two sentences
    [[nodiscard]] QStringList doubts() const;    ///< of the file itself
    [[nodiscard]] const LineChoices& choices() const { return choices_; }
    [[nodiscard]] TalkModel& talk() { return talk_; }
    [[nodiscard]] const VariableNames& names() const { return names_; }
    [[nodiscard]] const std::vector<protocol::PanelMatch>& matches() const { return matches_; }
    [[nodiscard]] const QString& matchSentence() const { return match_sentence_; }
    [[nodiscard]] const QString& searchSentence() const { return search_sentence_; }
    /// In the folder of the instruction tables, which is made: a dialog goes elsewhere when it is missing.
    [[nodiscard]] QString suggestedTablePath(const QString& routine) const;
    [[nodiscard]] static QString fileFilter();

public Q_SLOTS:
    void import(const QString& path);
    /// As another format, or with another sample rate, than the file says.
    void importAs(const QString& path, std::optional<pmts::protocol::CaptureFormat> format, std::optional<double> samples_per_s);
    /// The last file once more, with a rate as it is typed (`1 MHz`; blank: none).
    void importAgain(std::optional<pmts::protocol::CaptureFormat> format, const QString& rate);
    void cancel();
    void setDecoded(int line, bool decoded);
    void setFraming(int line, const pmts::protocol::Framing& framing);
    void useFound(int line, std::size_t place);  ///< of the scores; 0 is the best
    void setSide(int line, pmts::protocol::TalkSide side);
    void correlate(const QString& panel_text);
    void nameVariable(const QString& variable, const QString& name);
    /// The next or previous place that holds it, round the end; `[?` is every character that is not sure.
    void search(const QString& typed, bool forward);
    void searchFrom(std::size_t character) { search_at_ = character; }
    /// Every command and reply of the recording becomes a routine; the names become remarks.
    void saveTable(const QString& path, const QString& routine);

Q_SIGNALS:
    void changed();                      ///< findings, choices, names
    void busyChanged();
    void progressed(double share);       ///< 0 to 1
    void matchesChanged();
    void searched(qsizetype character);  ///< -1: it is nowhere
    void saved(const QString& path);

private:
    /// What the pool hands back: applied on the GUI thread.
    using Apply = std::function<void()>;
    using Work = std::function<Apply(const protocol::Progress&)>;

    void run(const QString& reason, Work work);
    void finish();
    void decodeAgain();
    void take(core::Result<LineFindings> findings);
    void fail(const core::Error& error);
    template <class Find, class RFind>
    [[nodiscard]] std::size_t placeFrom(bool forward, Find find, RFind rfind);

    MessageCentre& messages_;
    QString data_folder_, path_;
    Threading threading_;
    TalkModel talk_;
    VariableNames names_;
    std::shared_ptr<const LineFindings> findings_;
    LineChoices choices_;
    std::vector<protocol::PanelMatch> matches_;
    QString match_sentence_, search_sentence_, reason_;
    std::size_t search_at_ = 0;
    bool has_failed_ = false;
    QFutureWatcher<Apply> watcher_;
};

}  // namespace pmts::app
