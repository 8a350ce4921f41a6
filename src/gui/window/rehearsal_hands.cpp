#include "rehearsal_hands.hpp"

#include "field/field_workspace.hpp"
#include "field/live_panel.hpp"
#include "pmts/app/desk/workbench.hpp"
#include "pmts/gui/main_window.hpp"

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QTableView>
#include <QTest>
#include <opencv2/imgproc.hpp>

namespace pmts::gui {
namespace {

using namespace std::chrono_literals;

constexpr int kSearch_px = 6;        ///< how far the rig's prediction may be off
constexpr int kCornerWindow_px = 3;  ///< inside the smallest board, without its edges

/// Completes when the condition holds or the limit is over.
class Watch : public QObject {
public:
    Watch(std::function<bool()> seen, core::Clock& clock, core::Duration limit)
        : seen_(std::move(seen)),
          limit_(clock.callAfter(limit, [this] { done_.complete(core::cancelled()); })) {}

    void check() {
        if (seen_()) {
            done_.complete({});
        }
    }
    [[nodiscard]] auto answer() const { return done_.answer(); }

private:
    std::function<bool()> seen_;
    core::Completion<void> done_;
    core::Timer limit_;
};

/// Every change a presenter tells of, checked after those who show it have heard of it.
void follow(app::Workbench& bench, Watch& watch) {
    const auto check = [&watch] { watch.check(); };
    QObject::connect(&bench.job, &app::JobPresenter::jobChanged, &watch, check, Qt::QueuedConnection);
    QObject::connect(&bench.status, &app::StatusPresenter::changed, &watch, check, Qt::QueuedConnection);
    QObject::connect(&bench.live, &app::LivePresenter::sceneChanged, &watch, check, Qt::QueuedConnection);
    QObject::connect(&bench.live, &app::LivePresenter::stillCaptured, &watch, check, Qt::QueuedConnection);
    QObject::connect(&bench.targeting, &app::TargetingPresenter::targetChanged, &watch, check,
                     Qt::QueuedConnection);
    QObject::connect(&bench.targeting, &app::TargetingPresenter::movingChanged, &watch, check,
                     Qt::QueuedConnection);
    QObject::connect(&bench.recording, &app::RecordingPresenter::readingsChanged, &watch, check,
                     Qt::QueuedConnection);
    QObject::connect(&bench.recording, &app::RecordingPresenter::nextPointChanged, &watch, check,
                     Qt::QueuedConnection);
    QObject::connect(&bench.points, &app::PointsModel::pointsChanged, &watch, check, Qt::QueuedConnection);
    QObject::connect(&bench.station, &app::StationPresenter::stationChanged, &watch, check,
                     Qt::QueuedConnection);
    QObject::connect(&bench.job, &app::JobPresenter::exported, &watch, check, Qt::QueuedConnection);
}

/// Where four quadrants meet: the strongest saddle of the grey values near a place, then to sub-pixels.
std::optional<QPointF> quadrantsNear(const cv::Mat& image, const cv::Point2f& predicted) {
    const cv::Rect around(cvRound(predicted.x) - kSearch_px, cvRound(predicted.y) - kSearch_px,
                          2 * kSearch_px + 1, 2 * kSearch_px + 1);
    if ((around & cv::Rect(0, 0, image.cols, image.rows)) != around) {
        return std::nullopt;
    }
    cv::Mat grey, xx, yy, xy;
    cv::cvtColor(image(around), grey, cv::COLOR_BGR2GRAY);
    cv::Mat smooth;
    cv::GaussianBlur(grey, smooth, {}, 1.5);
    smooth.convertTo(smooth, CV_32F);
    cv::Sobel(smooth, xx, CV_32F, 2, 0);
    cv::Sobel(smooth, yy, CV_32F, 0, 2);
    cv::Sobel(smooth, xy, CV_32F, 1, 1);
    const cv::Mat saddle = xy.mul(xy) - xx.mul(yy);
    const cv::Rect inner(2, 2, saddle.cols - 4,
                         saddle.rows - 4);  // derivatives at the rim are not to be trusted
    cv::Point strongest;
    cv::minMaxLoc(saddle(inner), nullptr, nullptr, nullptr, &strongest);
    std::vector<cv::Point2f> corner{strongest + inner.tl()};
    cv::cornerSubPix(grey, corner, cv::Size(kCornerWindow_px, kCornerWindow_px), cv::Size(-1, -1),
                     cv::TermCriteria(cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 40, 0.01));
    return QPointF(around.x + corner[0].x, around.y + corner[0].y);
}

}  // namespace

Hands::Hands(MainWindow& window, app::Workbench& bench, QString folder)
    : window_(window), bench_(bench), folder_(std::move(folder)) {}

QWidget& Hands::root() const { return window_; }

ImageView& Hands::liveView() const { return window_.field().live().view(); }

FieldWorkspace& Hands::field() const { return window_.field(); }

const FieldActions& Hands::actions() const { return window_.actions(); }

core::Task<core::Result<void>> Hands::press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    window_.activateWindow();
    PMTS_STEP(
        until(u"the main window did not become active"_qs, 5s, [this] { return window_.isActiveWindow(); }));
    if (QWidget* const focus = window_.focusWidget(); focus == nullptr || !focus->isVisible()) {
        liveView().setFocus();
    }
    QTest::keyClick(window_.focusWidget() != nullptr ? window_.focusWidget() : &window_, key, modifiers);
    co_return {};
}

void Hands::pressIn(QWidget* where, const char* field, Qt::Key key) {
    QTest::keyClick(where->findChild<QWidget*>(QString::fromLatin1(field)), key);
}

void Hands::type(QWidget* where, const char* field, const QString& text) {
    auto* const edit = where->findChild<QLineEdit*>(QString::fromLatin1(field));
    QTest::mouseClick(edit, Qt::LeftButton, {}, edit->rect().center());
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Tab);
}

void Hands::clickText(QWidget* where, const QString& button_text) {
    const auto buttons = where->findChildren<QPushButton*>();
    for (QPushButton* button : buttons) {
        if (button->text().remove(u'&') == button_text) {
            QTest::mouseClick(button, Qt::LeftButton);
            return;
        }
    }
}

void Hands::click(QWidget& widget, const QPointF& at) {
    QTest::mouseClick(&widget, Qt::LeftButton, {}, (at - QPointF(0.5, 0.5)).toPoint());
}

void Hands::hover(QWidget& widget, const QPointF& at) {
    QMouseEvent move(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&widget, &move);
}

void Hands::doubleClick(QWidget& widget, const QPointF& at) {
    QTest::mouseDClick(&widget, Qt::LeftButton, {}, (at - QPointF(0.5, 0.5)).toPoint());
}

void Hands::doubleClickFirstRow(const QString& table, QDockWidget* dock) {
    auto* const view = dock->findChild<QTableView*>(table);
    const QPoint at = view->visualRect(view->model()->index(0, 0)).center();
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(view->viewport(), Qt::LeftButton, {}, at);
}

QWidget* Hands::window(const QString& name) const {
    const auto dialogs = window_.findChildren<QDialog*>(name);
    for (QDialog* dialog : dialogs) {
        if (dialog->isVisible()) {
            return dialog;
        }
    }
    return nullptr;
}

void Hands::closeWindow(QWidget* dialog) {
    QTest::keyClick(dialog, Qt::Key_Escape);
    window_.activateWindow();
    liveView().setFocus();
}

void Hands::save(const QPixmap& picture, const QString& name) const {
    picture.save(QDir(folder_).filePath(name));
}

void Hands::shoot(const QString& name, Again again) {
    if (again == Again::kReplace || !QFileInfo::exists(QDir(folder_).filePath(name))) {
        save(window_.grab(), name);
    }
}

void Hands::shootWith(QWidget* dialog, const QString& name) {
    QPixmap picture = window_.grab();
    const QPixmap page = dialog->grab();
    const QPoint at((window_.width() - dialog->width()) / 2, (window_.height() - dialog->height()) / 2);
    QPainter painter(&picture);
    painter.fillRect(QRect(at, dialog->size()).adjusted(-2, -2, 2, 2), window_.palette().text());
    painter.drawPixmap(at, page);
    painter.end();
    save(picture, name);
}

core::Task<core::Result<void>> Hands::until(QString sentence, core::Duration limit,
                                            std::function<bool()> seen) {
    Watch watch(std::move(seen), clock_, limit);
    follow(bench_, watch);
    watch.check();
    auto answer = watch.answer();
    const auto outcome = co_await answer;
    if (!outcome) {
        co_return core::fail(core::ErrorKind::kTimeOut, u"The rehearsal stopped: "_qs + sentence + u'.');
    }
    co_return {};
}

core::Task<core::Result<void>> Hands::pause(core::Duration span) {
    PMTS_STEP(core::sleepFor(clock_, span));
    co_return {};
}

core::Task<core::Result<void>> Hands::settle() {
    PMTS_STEP(core::sleepFor(clock_, 150ms));
    co_return {};
}

core::Task<core::Result<void>> Hands::freshFrame() {
    const core::Duration from = clock_.now() + 250ms;  // a reading of the circles on both sides of the frame
    PMTS_STEP(until(u"the live view stood still"_qs, 10s, [this, from] {
        const app::LiveScene& scene = bench_.live.scene();
        return scene.frame && scene.pointing && scene.frame->captured_at > from &&
               liveView().frame() == scene.frame;
    }));
    co_return {};
}

std::optional<QPointF> Hands::markPixel(const KnownMark& mark) const {
    const app::LiveScene& scene = bench_.live.scene();
    const auto predicted = bench_.live.model().pixelForPoint({mark.x_m, mark.y_m, mark.z_m}, *scene.pointing);
    if (!predicted) {
        return std::nullopt;
    }
    return quadrantsNear(scene.frame->image,
                         cv::Point2f(static_cast<float>(predicted->x()), static_cast<float>(predicted->y())));
}

}  // namespace pmts::gui
