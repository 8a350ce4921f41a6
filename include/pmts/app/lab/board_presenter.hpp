#pragma once

#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/desk/threading.hpp"
#include "pmts/calibration/board_calibration.hpp"
#include "pmts/camera/lens_difference.hpp"

#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <optional>
#include <vector>

namespace pmts::app {

/// Views of a board from the live picture or a folder, the lens they give, and how it differs from the one in use.
/// Looking and adjusting are done on a thread of its own, newest picture only.
class BoardPresenter : public QObject {
    Q_OBJECT
public:
    BoardPresenter(LivePresenter& live, Preferences& preferences, MessageCentre& messages, const core::Clock& clock,
                   Threading threading = Threading::kOwnThread, QObject* parent = nullptr);
    ~BoardPresenter() override;  ///< waits for what is being looked at

    [[nodiscard]] const calibration::BoardPattern& pattern() const { return preferences_.settings().rig_care.board; }
    [[nodiscard]] bool isLooking() const { return looking_; }
    [[nodiscard]] bool isAdjusting() const { return adjusting_; }
    [[nodiscard]] const std::vector<calibration::BoardView>& views() const { return views_; }
    [[nodiscard]] const std::optional<calibration::BoardView>& seen() const { return seen_; }  ///< in the newest picture looked at
    [[nodiscard]] const QString& sentence() const { return sentence_; }  ///< what to do, or why not
    [[nodiscard]] const std::optional<calibration::BoardCalibration>& result() const { return result_; }
    [[nodiscard]] const std::optional<camera::LensDifference>& difference() const { return difference_; }
    [[nodiscard]] QString resultText() const;
    /// The board as cells to print, and the side of a cell; kBadInput like usablePattern().
    struct Sheet {
        cv::Mat cells;
        double cell_mm = 0.0;
        QString caption;
    };
    [[nodiscard]] core::Result<Sheet> sheet() const;
    [[nodiscard]] static QStringList dictionaries() { return calibration::boardDictionaries(); }
    [[nodiscard]] QString verdict() const;   ///< against the rig in use
    [[nodiscard]] DeviceState verdictState() const;

public Q_SLOTS:
    void setPattern(const pmts::calibration::BoardPattern& pattern);
    void setLooking(bool on);     ///< takes a view by itself when the board is found, sharp and new
    void removeView(int index);
    void clear();
    void calibrate();
    void calibrateFolder(const QString& folder);
    void cancel();
    void acceptLens();            ///< keeps the mount of the rig in use

Q_SIGNALS:
    void changed();
    void viewTaken(int count);

private:
    void lookAtFrame();
    void onLooked(const core::Result<calibration::BoardView>& view);
    void onAdjusted(const core::Result<calibration::BoardCalibration>& result);
    void adjust(std::function<core::Result<calibration::BoardCalibration>()> work);
    void compare();
    void say(const QString& sentence);
    void run(std::function<void()> work);

    LivePresenter& live_;
    Preferences& preferences_;
    MessageCentre& messages_;
    const core::Clock& clock_;
    Threading threading_;
    bool looking_ = false;
    bool busy_ = false;      ///< a picture is being looked at
    bool adjusting_ = false;
    std::atomic<bool> cancelled_ = false;
    std::vector<calibration::BoardView> views_;
    std::optional<calibration::BoardView> seen_;
    std::optional<calibration::BoardView> before_;  ///< seen in the picture before: a board that is held still
    QString sentence_;
    std::optional<calibration::BoardCalibration> result_;
    std::optional<camera::LensDifference> difference_;
    QThreadPool pool_;
};

}  // namespace pmts::app
