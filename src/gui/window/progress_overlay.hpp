#pragma once

#include <QFrame>

#include <memory>

namespace Ui {
class ProgressOverlay;
}

namespace pmts::gui {

/// What the instrument is busy with, over the upper edge of its parent, with Cancel.
class ProgressOverlay : public QFrame {
    Q_OBJECT
public:
    explicit ProgressOverlay(QWidget* parent);
    ~ProgressOverlay() override;

    /// `fraction` 0..1; 0 shows a bar without an end.
    void showBusy(const QString& text, double fraction);

Q_SIGNALS:
    void cancelled();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    std::unique_ptr<Ui::ProgressOverlay> ui_;
};

}  // namespace pmts::gui
