#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/lab/lab_calibration.hpp"
#include "pmts/app/field/range_keeper.hpp"
#include "pmts/calibration/mount_fit.hpp"

#include <QObject>
#include <QPointF>

#include <optional>
#include <vector>

namespace pmts::app {

/// What the next distance and the next click belong to.
enum class ParallaxStage { kFar, kNear, kAside, kAccept, kVerify };

/// A line of the procedure, lettered as in the thesis.
struct ParallaxStep {
    QString text;
    bool done = false;
    bool current = false;
};

/// X/Z parallax with two boards at D and 2D (and Yo, with sightings aside), measured in the picture and with the
/// instrument's distances; what was found is verified afterwards on any mark.
class ParallaxPresenter : public QObject {
    Q_OBJECT
public:
    static constexpr double kGood_px = 1.0;  ///< of the verification

    ParallaxPresenter(LivePresenter& live, InstrumentDesk& instrument, RangeKeeper& range, Preferences& preferences,
                      MessageCentre& messages, Threading threading = Threading::kOwnThread, QObject* parent = nullptr);

    [[nodiscard]] const calibration::OffsetCase& sought() const { return sought_; }
    [[nodiscard]] ParallaxStage stage() const { return stage_; }
    [[nodiscard]] DeviceState state() const;
    [[nodiscard]] QString step() const;  ///< what to do next, one sentence
    [[nodiscard]] std::vector<ParallaxStep> steps() const;
    [[nodiscard]] QString boardsAdvice() const;  ///< where the near board may hang, and whether it does
    [[nodiscard]] QString distanceText() const;  ///< of the board of this stage
    [[nodiscard]] QString gapText() const;
    [[nodiscard]] QString offsetsText() const;
    [[nodiscard]] QString proofText() const;
    /// The mark under the telescope has its distance and is to be clicked.
    [[nodiscard]] bool wantsClick() const { return stage_ != ParallaxStage::kAccept && board().target.has_value(); }
    [[nodiscard]] bool canAccept() const { return fit_.has_value(); }
    [[nodiscard]] bool isMeasuring() const { return ticket_ != 0; }
    [[nodiscard]] const std::optional<calibration::MountFit>& fit() const { return fit_; }
    [[nodiscard]] std::optional<QPointF> clickedPixel() const { return clicked_px_; }

public Q_SLOTS:
    void setSought(const pmts::calibration::OffsetCase& sought);
    void setStage(pmts::app::ParallaxStage stage);
    void measure();                       ///< the telescope is on the mark: distance and readings
    void setDistance(double distance_m);  ///< typed, with the readings of now
    void click(const QPointF& frame_px);  ///< the mark is here in the live view; it snaps
    void accept();
    void startAgain();

Q_SIGNALS:
    void changed();

private:
    struct Board {
        std::optional<geometry::PolarPoint> target;
        std::vector<calibration::Sighting> sightings;
    };

    [[nodiscard]] Board& board();
    [[nodiscard]] const Board& board() const;
    [[nodiscard]] bool isSighted(const Board& board) const;
    [[nodiscard]] std::vector<calibration::Sighting> allSightings() const;
    [[nodiscard]] bool wantsAside() const { return sought_.y && near_.sightings.size() < 3; }
    void take(const calibration::Sighting& sighting);
    void goOn();
    void solve();
    void judge(const calibration::Sighting& proof);
    void say(const QString& trouble);

    LivePresenter& live_;
    InstrumentDesk& instrument_;
    RangeKeeper& range_;
    Preferences& preferences_;
    MessageCentre& messages_;
    Threading threading_;
    calibration::OffsetCase sought_{.others_are_known = true};
    ParallaxStage stage_ = ParallaxStage::kFar;
    Board far_, near_, proof_;
    Ticket ticket_ = 0;
    std::optional<QPointF> clicked_px_;
    std::optional<calibration::BoardGap> gap_;
    std::optional<calibration::MountFit> fit_;
    bool is_accepted_ = false;
    std::optional<double> proof_px_;
    QString proof_text_;
    QString trouble_;
};

}  // namespace pmts::app
