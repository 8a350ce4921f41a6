#pragma once

#include <QWidget>

#include <memory>

namespace Ui {
class ModeBar;
}

namespace pmts::gui {

/// The workspaces that exist, at the left.
class ModeBar : public QWidget {
    Q_OBJECT
public:
    enum class Mode { kField, kLab, kLine };

    explicit ModeBar(QWidget* parent = nullptr);
    ~ModeBar() override;

    void setMode(Mode mode);

Q_SIGNALS:
    void modeChosen(pmts::gui::ModeBar::Mode mode);

private:
    std::unique_ptr<Ui::ModeBar> ui_;
};

}  // namespace pmts::gui
