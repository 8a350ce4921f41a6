#pragma once

#include "pmts/app/field/apa_presenter.hpp"
#include "pmts/app/settings/preferences.hpp"

#include <QDialog>

#include <memory>

namespace Ui {
class ApaDialog;
}

namespace pmts::gui {

/// Guides through the measurement of the average pixel angle. Modeless: the telescope is pointed meanwhile.
class ApaDialog : public QDialog {
    Q_OBJECT
public:
    ApaDialog(app::ApaPresenter& apa, const app::InstrumentDesk& instrument, const app::Preferences& preferences,
              QWidget* parent = nullptr);
    ~ApaDialog() override;

private:
    void wirePicture();
    void showAll();
    void showObjects();
    void showPicture();
    void say(const QString& sentence);

    app::ApaPresenter& apa_;
    std::unique_ptr<Ui::ApaDialog> ui_;
};

}  // namespace pmts::gui
