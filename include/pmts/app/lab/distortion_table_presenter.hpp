#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/lab/lab_calibration.hpp"
#include "pmts/app/field/range_keeper.hpp"
#include "pmts/calibration/distortion_table.hpp"

#include <QObject>
#include <QPointF>
#include <QSize>

#include <optional>
#include <vector>

namespace pmts::app {

/// What the two plots show (thesis, fig. 5.14 and 5.15), angles in gon.
struct TablePlots {
    struct Curve {
        QString name;  ///< `5.333 m, right`; `table`; `ideal lens`
        std::vector<double> radius_px, value_gon;
        bool measured = true;  ///< false: the table and the ideal ones, drawn as lines of their own
    };
    std::vector<Curve> angle;  ///< cumulative angle against the pixel
    std::vector<Curve> width;  ///< width of a pixel against the pixel
};

/// A row as people edit it.
struct TableRowText {
    QString radius, angle, deviation, spread;
};

/// The distortion table (thesis 5.5.1.7): a fixed target is led along radii of the picture, by the program or by hand, at
/// one or more distances; the rows are shown, edited, kept as the lens of the rig.
class DistortionTablePresenter : public QObject {
    Q_OBJECT
public:
    DistortionTablePresenter(LivePresenter& live, InstrumentDesk& instrument, const RangeKeeper& range, Preferences& preferences,
                             MessageCentre& messages, Threading threading = Threading::kOwnThread, QObject* parent = nullptr);

    [[nodiscard]] DeviceState state() const;
    [[nodiscard]] QString step() const;  ///< what to do next, one sentence
    [[nodiscard]] QString progressText() const;
    [[nodiscard]] double progress() const;  ///< 0 to 1 of the running sweep
    [[nodiscard]] bool isSweeping() const { return ticket_ != 0; }
    [[nodiscard]] bool canStart() const { return target_.has_value() && !isSweeping(); }
    [[nodiscard]] double stepPx() const { return step_px_; }
    [[nodiscard]] const std::vector<calibration::RadiusDirection>& directions() const { return directions_; }
    [[nodiscard]] bool isByHand() const { return by_hand_; }
    [[nodiscard]] QString targetText() const;  ///< `5.333 m (measured)`
    [[nodiscard]] QStringList runTexts() const;  ///< one line a distance
    [[nodiscard]] std::vector<calibration::PlannedSpot> grid() const;  ///< where the target is to go
    [[nodiscard]] const std::vector<QPointF>& seenPixels() const { return seen_px_; }  ///< of the run being made
    [[nodiscard]] Eigen::Vector2d centre() const { return live_.model().rig().lens.principalPoint(); }

    [[nodiscard]] QSize pictureSize() const { return {live_.model().rig().width_px, live_.model().rig().height_px}; }

    [[nodiscard]] std::vector<TableRowText> rows() const;
    [[nodiscard]] QString rowsTrouble() const;  ///< why the rows make no table; empty when they do
    [[nodiscard]] bool canAccept() const;
    [[nodiscard]] QString summary() const;  ///< deviation at the edge, how far the curves are apart
    [[nodiscard]] TablePlots plots() const;

public Q_SLOTS:
    void setStep(double step_px);  ///< held between 5 and 200 px
    void setDirections(const std::vector<pmts::calibration::RadiusDirection>& directions);
    void setByHand(bool by_hand);
    /// The target is here; it snaps. By hand: the same target is here now.
    void click(const QPointF& frame_px);
    void start();   ///< turns the instrument through the radii
    void cancel();
    void newTarget();  ///< the next click chooses one, at another distance
    void removeRun(int index);
    void setRow(int row, const QString& radius_px, const QString& angle);  ///< angle in any unit
    void addRow();
    void removeRow(int row);
    void forgetEdits();  ///< back to what was measured
    void accept();
    void importCsv(const QString& path);
    void exportCsv(const QString& path);

Q_SIGNALS:
    void changed();
    void progressed();  ///< of a sweep

private:
    using Row = camera::RadialTableLens::Row;

    struct Target {
        camera::FramePtr frame;
        geometry::Pointing at;
        Eigen::Vector2d px;
        geometry::PolarPoint place;
        RangeSource source = RangeSource::kAssumed;
    };

    void choose(const camera::FramePtr& frame, const geometry::Pointing& at, const Eigen::Vector2d& px);
    void addByHand(const geometry::Pointing& at, const Eigen::Vector2d& px);
    [[nodiscard]] std::vector<geometry::Pointing> pointings() const;
    void onStep(const targeting::SweepStep& step);
    void onSwept(const targeting::SweepOutcome& outcome);
    void keepRun(const calibration::TableRun& run);
    void compute();
    void say(const QString& trouble);

    LivePresenter& live_;
    InstrumentDesk& instrument_;
    const RangeKeeper& range_;
    Preferences& preferences_;
    MessageCentre& messages_;
    Threading threading_;
    double step_px_ = 30.0;
    std::vector<calibration::RadiusDirection> directions_{calibration::RadiusDirection::kRight, calibration::RadiusDirection::kLeft};
    bool by_hand_ = false;
    std::optional<Target> target_;
    Ticket ticket_ = 0;
    std::size_t done_ = 0, of_ = 0, missed_ = 0;
    std::vector<QPointF> seen_px_;
    std::vector<calibration::TableRun> runs_;
    std::vector<calibration::TableCurve> curves_;
    std::vector<double> spread_rad_;
    std::vector<Row> rows_;
    Eigen::Vector2d table_centre_ = Eigen::Vector2d::Zero();
    bool is_edited_ = false;
    bool is_accepted_ = false;
    QString trouble_;
};

}  // namespace pmts::app
