#pragma once

#include "pmts/app/line/memory_presenter.hpp"

#include <QDialog>

class QComboBox;
class QLineEdit;
class QPushButton;

namespace pmts::gui {

/// As what and under which name a file goes into the instrument.
class SendFileDialog : public QDialog {
    Q_OBJECT
public:
    SendFileDialog(const instrument::MemoryFileId& proposed, const QString& reason, QWidget* parent = nullptr);

    [[nodiscard]] instrument::MemoryFileId file() const;

private:
    QComboBox* kind_;
    QLineEdit* name_;
    QPushButton* send_;
};

}  // namespace pmts::gui
