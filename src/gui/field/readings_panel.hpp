#pragma once

#include "pmts/app/desk/device_state.hpp"
#include "pmts/app/field/recording_presenter.hpp"

#include <QFrame>

#include <memory>

namespace Ui {
class ReadingsPanel;
}

namespace pmts::gui {

/// The big digits: HA VA SD, E N H, precision; right aligned, at least 28 px high. An old shot is slanted and
/// says so.
class ReadingsPanel : public QFrame {
    Q_OBJECT
public:
    static constexpr int kLeastDigits_px = 28;

    explicit ReadingsPanel(QWidget* parent = nullptr);
    ~ReadingsPanel() override;

    void showReadings(const app::Readings& readings);
    /// Circle readings of an instrument that does not answer are old: slanted, with the reason on hover.
    void setCirclesLive(bool live);

protected:
    void changeEvent(QEvent* event) override;

private:
    void sizeDigits();
    void showShot(const app::Readings& readings);

    std::unique_ptr<Ui::ReadingsPanel> ui_;
    bool sizing_ = false;
};

/// Lamp and words for what is known about the shot.
[[nodiscard]] app::StatusItem shotStatus(app::ShotState state);

}  // namespace pmts::gui
