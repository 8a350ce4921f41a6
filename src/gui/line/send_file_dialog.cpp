#include "send_file_dialog.hpp"

#include "parts/lab_parts.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>

namespace pmts::gui {
namespace {

constexpr int kLongestName = 15;
constexpr int kLeastWidth_px = 400;  ///< its title in whole

}  // namespace

SendFileDialog::SendFileDialog(const instrument::MemoryFileId& proposed, const QString& reason, QWidget* parent)
    : QDialog(parent), kind_(new QComboBox(this)), name_(new QLineEdit(proposed.name, this)), send_(nullptr) {
    setWindowTitle(tr("Send to the instrument"));
    setMinimumWidth(kLeastWidth_px);
    auto* const form = new QFormLayout(this);
    if (!reason.isEmpty()) {
        auto* const why = labText("send_reason", this);
        why->setText(reason);
        form->addRow(why);
    }
    for (const auto directory : {protocol::Directory::kJob, protocol::Directory::kArea}) {
        kind_->addItem(app::MemoryPresenter::nameOf(directory), static_cast<int>(directory));
    }
    kind_->setObjectName(QStringLiteral("send_kind"));
    kind_->setMinimumHeight(ActionButton::kLeastSide_px);
    kind_->setCurrentIndex(kind_->findData(static_cast<int>(proposed.directory)));
    name_->setObjectName(QStringLiteral("send_name"));
    name_->setMinimumHeight(ActionButton::kLeastSide_px);
    name_->setMaxLength(kLongestName);
    name_->selectAll();
    form->addRow(tr("As"), kind_);
    form->addRow(tr("Name"), name_);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    send_ = buttons->addButton(tr("Send"), QDialogButtonBox::AcceptRole);
    for (auto* const button : buttons->buttons()) {
        button->setMinimumHeight(ActionButton::kLeastSide_px);
    }
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(name_, &QLineEdit::textChanged, send_,
            [this](const QString& name) { send_->setEnabled(!name.trimmed().isEmpty()); });
}

instrument::MemoryFileId SendFileDialog::file() const {
    return {static_cast<protocol::Directory>(kind_->currentData().toInt()), name_->text().trimmed()};
}

}  // namespace pmts::gui
