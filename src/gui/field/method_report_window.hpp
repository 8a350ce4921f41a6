#pragma once

#include "pmts/app/field/method_report_presenter.hpp"

#include <QDialog>
#include <QLineEdit>

#include <map>
#include <memory>
#include <optional>

namespace Ui {
class MethodReportWindow;
}

namespace pmts::gui {

/// The method report: the list of targets, the camera of their photo, all methods side by side. Modeless.
class MethodReportWindow : public QDialog {
    Q_OBJECT
public:
    explicit MethodReportWindow(app::MethodReportPresenter& report, QWidget* parent = nullptr);
    ~MethodReportWindow() override;

    /// The format is told by the ending: .txt, .csv or .pdf.
    void saveReport(const QString& path);

private:
    void setUpTables();
    void wireList();
    void wireCollecting();
    void wireReport();
    void showForm();
    [[nodiscard]] app::MethodReportForm typedForm() const;
    void markWrong(app::ReportField field, const core::Error& error);
    void showList();
    void showStills();
    void showStill();
    void showPoints();
    void showCaption(const std::optional<QPointF>& cursor_px);
    void showReport();
    void showRunning(bool running);
    void say(const QString& sentence);
    void complain(const core::Error& error);
    void chooseReportFile(const QString& ending, const QString& filter);

    app::MethodReportPresenter& report_;
    std::unique_ptr<Ui::MethodReportWindow> ui_;
    std::map<app::ReportField, QLineEdit*> fields_;
};

}  // namespace pmts::gui
