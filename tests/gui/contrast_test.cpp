#include "field/apa_dialog.hpp"
#include "bench_fixture.hpp"
#include "window/connection_dialog.hpp"
#include "field/depth_popup.hpp"
#include "field/field_actions.hpp"
#include "window/message_area.hpp"
#include "field/method_report_window.hpp"
#include "window/progress_overlay.hpp"
#include "field/range_dialog.hpp"
#include "window/small_dialogs.hpp"
#include "field/station_dialog.hpp"
#include "lab/vidformat_dialog.hpp"

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QTabBar>

#include <map>

namespace pmts::gui {
namespace {

constexpr int kEdge_px = 5;  ///< borders and focus rings are not text

/// Contrast of the ink in a picture of a widget: the commonest colour is the ground, the ink is what differs
/// from it most.
double contrastOfInk(const QImage& picture) {
    std::map<QRgb, int> count;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            ++count[picture.pixel(x, y)];
        }
    }
    const auto ground = std::ranges::max_element(count, {}, &std::pair<const QRgb, int>::second);
    double best = 1.0;
    for (const auto& [color, times] : count) {
        best = std::max(best, contrastRatio(QColor(color), QColor(ground->first)));
    }
    return best;
}

bool carriesText(const QWidget* widget) {
    if (const auto* const label = qobject_cast<const QLabel*>(widget)) {
        return !label->text().isEmpty();
    }
    if (const auto* const button = qobject_cast<const QAbstractButton*>(widget)) {
        return !button->text().isEmpty();
    }
    if (const auto* const field = qobject_cast<const QLineEdit*>(widget)) {
        return !field->text().isEmpty() && !field->hasSelectedText();
    }
    return false;
}

class ContrastTest : public test::WindowFixture, public testing::WithParamInterface<PaletteName> {
protected:
    void SetUp() override { window->usePalette(GetParam()); }
    void TearDown() override { window->usePalette(PaletteName::kDay); }

    void check(QWidget& form) {
        form.show();
        QCoreApplication::sendPostedEvents();
        const QImage whole = form.grab().toImage().convertToFormat(QImage::Format_RGB32);
        int checked = 0;
        for (const QWidget* widget : form.findChildren<QWidget*>()) {
            if (!widget->isVisibleTo(&form) || widget->window() != form.window() || !carriesText(widget)) {
                continue;
            }
            QRect place = QRect(widget->mapTo(&form, QPoint(0, 0)), widget->size()).intersected(form.rect());
            place = qobject_cast<const QLabel*>(widget)
                        ? place
                        : place.adjusted(kEdge_px, kEdge_px, -kEdge_px, -kEdge_px);
            if (place.width() < 4 || place.height() < 4) {
                continue;
            }
            ++checked;
            EXPECT_GE(contrastOfInk(whole.copy(place)), themeNamed(GetParam()).wanted_contrast - 0.02)
                << form.metaObject()->className() << ": " << widget->objectName().toStdString() << " in "
                << textOf(GetParam()).toStdString();
        }
        EXPECT_GT(checked, 0);
    }

    /// The window with each row of a list chosen in turn.
    void checkEachOf(const QString& list_name) {
        window->setWindowState(Qt::WindowNoState);
        window->resize(1280, 800);
        auto& rows = *window->findChild<QListWidget*>(list_name);
        for (int row = 0; row < rows.count(); ++row) {
            SCOPED_TRACE(rows.item(row)->text().toStdString());
            rows.setCurrentRow(row);
            check(*window);
        }
    }
};

TEST_P(ContrastTest, MainWindow) {
    window->setWindowState(Qt::WindowNoState);
    window->resize(1280, 800);
    check(*window);
}

TEST_P(ContrastTest, EveryStepOfTheLaboratory) {
    window->openLab(QStringLiteral("camera_step"));
    checkEachOf(QStringLiteral("lab_steps"));
}

TEST_P(ContrastTest, EveryPageOfTheLine) {
    window->actions().line->trigger();
    checkEachOf(QStringLiteral("line_pages"));
}

TEST_P(ContrastTest, VideoFormat) {
    VidformatDialog dialog(bench->camera);
    check(dialog);
}

TEST_P(ContrastTest, StationDialog) {
    StationDialog dialog(bench->station, bench->instrument, bench->preferences);
    check(dialog);
}

TEST_P(ContrastTest, ConnectionDialog) {
    ConnectionDialog dialog(*bench);
    for (const auto page : {ConnectionDialog::Page::kInstrument, ConnectionDialog::Page::kCamera,
                            ConnectionDialog::Page::kRig}) {
        dialog.openPage(page);
        check(dialog);
    }
}

TEST_P(ContrastTest, MethodReportAndApa) {
    bench->method_report.openThesisExample();
    app::MethodReportForm form = bench->method_report.form();
    form.rig = app::RigOfReport::kNominal;
    bench->method_report.run(form);
    MethodReportWindow report(bench->method_report);
    check(report);
    ApaDialog apa(bench->apa, bench->instrument, bench->preferences);
    check(apa);
}

TEST_P(ContrastTest, SmallDialogs) {
    UnitsDialog units(bench->preferences.units());
    KeysDialog keys(window->actions().withKeys());
    AboutDialog about;
    StepDialog step(QStringLiteral("5'"), bench->preferences.units());
    AimDialog aim(bench->preferences.units());
    ExportDialog exported(QStringLiteral("/tmp/points.csv"), {});
    for (QDialog* dialog :
         {static_cast<QDialog*>(&units), static_cast<QDialog*>(&keys), static_cast<QDialog*>(&about),
          static_cast<QDialog*>(&step), static_cast<QDialog*>(&aim), static_cast<QDialog*>(&exported)}) {
        check(*dialog);
    }
}

TEST_P(ContrastTest, RangeAndDepth) {
    RangeDialog range(bench->ranges, bench->preferences.units());
    check(range);
    DepthPopup depth(bench->ranges);
    check(depth);
}

TEST_P(ContrastTest, MessagesToastAndProgress) {
    app::Message message;
    message.happened = QStringLiteral("The instrument is gone.");
    message.remedy = QStringLiteral("Check the cable.");
    message.action = app::MessageAction::kReconnect;
    message.action_text = QStringLiteral("Connect again");
    message.details = QStringLiteral("read error");
    MessageArea area;
    area.resize(900, 80);
    area.showBars({message});
    check(area);
    QWidget ground;
    ground.resize(600, 200);
    Toast toast(&ground);
    toast.showText(QStringLiteral("Point 104 is recorded."));
    ProgressOverlay progress(&ground);
    progress.showBusy(QStringLiteral("Measuring, usually 5 s"), 0.4);
    check(ground);
}

TEST_P(ContrastTest, AnEmptyTickBoxIsSeen) {
    QWidget ground;
    ground.resize(60, 40);
    QCheckBox box(&ground);
    box.resize(60, 40);
    EXPECT_GE(contrastOfInk(ground.grab().toImage()), 3.0);
}

INSTANTIATE_TEST_SUITE_P(EveryPalette, ContrastTest,
                         testing::Values(PaletteName::kDay, PaletteName::kNight, PaletteName::kSun),
                         [](const auto& palette) { return textOf(palette.param).toStdString(); });

}  // namespace
}  // namespace pmts::gui
