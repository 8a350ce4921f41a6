#pragma once

#include "pmts/app/desk/serial_choice.hpp"

#include <QWidget>

#include <vector>

class QComboBox;

namespace pmts::gui {

/// A serial port and its line: chosen from the ports with their friendly names or typed as a path, baud and framing.
class PortForm : public QWidget {
    Q_OBJECT
public:
    explicit PortForm(QWidget* parent = nullptr);

    void setPorts(const std::vector<app::PortChoice>& ports);
    void showChoice(const app::SerialChoice& choice);
    /// What the form shows now; a typed path has no adapter.
    [[nodiscard]] app::SerialChoice choice() const;

Q_SIGNALS:
    void lookAgainRequested();

private:
    std::vector<app::PortChoice> ports_;
    QComboBox* port_;
    QComboBox* baud_;
    QComboBox* framing_;
};

}  // namespace pmts::gui
