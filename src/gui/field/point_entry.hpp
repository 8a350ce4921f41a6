#pragma once

#include "pmts/app/settings/preferences.hpp"
#include "pmts/app/field/recording_presenter.hpp"

#include <QWidget>

#include <memory>

class QLineEdit;

namespace Ui {
class PointEntry;
}

namespace pmts::gui {

/// What the next point is called: ID, code, remark, target height, distance mode, and a button for each usual
/// code.
class PointEntry : public QWidget {
    Q_OBJECT
public:
    PointEntry(app::RecordingPresenter& recording, app::Preferences& preferences, QWidget* parent = nullptr);
    ~PointEntry() override;

    void startTyping();  ///< the P key

Q_SIGNALS:
    void typingEnded();  ///< Enter in one of the fields

private:
    void wireFields();
    void passOn(QLineEdit* field, void (app::RecordingPresenter::*setter)(const QString&));
    void showText(QLineEdit* field, const QString& text);
    void showNextPoint();
    void showCodes();
    void showHeightProblem(const core::Error& error);

    app::RecordingPresenter& recording_;
    std::unique_ptr<Ui::PointEntry> ui_;
    QLineEdit* typed_in_ = nullptr;
};

}  // namespace pmts::gui
