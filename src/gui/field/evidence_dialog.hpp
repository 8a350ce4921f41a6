#pragma once

#include "pmts/app/field/evidence_presenter.hpp"

#include <QDialog>

#include <memory>

namespace Ui {
class EvidenceDialog;
}

namespace pmts::gui {

/// How a recorded point was aimed: pictures before and after with reticle and spot, and the numbers. Saved as
/// a PDF or printed as the same page.
class EvidenceDialog : public QDialog {
    Q_OBJECT
public:
    explicit EvidenceDialog(app::EvidencePresenter& evidence, QWidget* parent = nullptr);
    ~EvidenceDialog() override;

    /// Where a PDF goes when nobody chooses another place.
    void setFolder(const QString& folder) { folder_ = folder; }
    /// Says in the dialog whether it was written.
    void saveTo(const QString& path);

private:
    void showSheet();
    void choosePdf();
    void print();

    app::EvidencePresenter& evidence_;
    QString folder_;
    std::unique_ptr<Ui::EvidenceDialog> ui_;
};

}  // namespace pmts::gui
