#pragma once

#include "pmts/core/clock.hpp"
#include "pmts/core/task.hpp"
#include "pmts/gui/rehearsal.hpp"

#include <QPixmap>
#include <QPointF>
#include <QString>

#include <functional>
#include <optional>

class QDockWidget;
class QWidget;

/// Does a step of the rehearsal and ends it when the step failed. The task has a name before it is awaited:
/// gcc 12 destroys temporaries of an awaited expression twice.
#define PMTS_STEP(expression)                                            \
    do {                                                                 \
        auto pmts_step = expression;                                     \
        auto pmts_outcome = co_await pmts_step;                          \
        if (!pmts_outcome) {                                             \
            co_return ::tl::unexpected(std::move(pmts_outcome).error()); \
        }                                                                \
    } while (false)

namespace pmts::gui {

class FieldActions;
class FieldWorkspace;
class ImageView;
class MainWindow;

/// A surveyor's hands and eyes for the rehearsal: clicks and keys on the real widgets, waiting for what
/// should be seen.
class Hands {
public:
    enum class Again { kReplace, kKeepFirst };

    Hands(MainWindow& window, app::Workbench& bench, QString folder);

    [[nodiscard]] QWidget& root() const;
    [[nodiscard]] ImageView& liveView() const;
    [[nodiscard]] FieldWorkspace& field() const;
    [[nodiscard]] const FieldActions& actions() const;

    /// A key in the main window, once that is the active one again.
    [[nodiscard]] core::Task<core::Result<void>> press(Qt::Key key, Qt::KeyboardModifiers modifiers = {});
    void pressIn(QWidget* where, const char* field, Qt::Key key);
    /// Replaces the text of a field, key by key, and leaves it.
    void type(QWidget* where, const char* field, const QString& text);
    void clickText(QWidget* where, const QString& button_text);
    void click(QWidget& widget, const QPointF& at);
    void hover(QWidget& widget, const QPointF& at);
    void doubleClick(QWidget& widget, const QPointF& at);
    void doubleClickFirstRow(const QString& table, QDockWidget* dock);
    /// The visible dialog of this name, or null.
    [[nodiscard]] QWidget* window(const QString& name) const;
    void closeWindow(QWidget* dialog);

    void shoot(const QString& name, Again again = Again::kReplace);
    void shootWith(QWidget* dialog, const QString& name);

    /// Waits until the window shows it: checked at every change a presenter tells of. kTimeOut with the
    /// sentence.
    [[nodiscard]] core::Task<core::Result<void>> until(QString sentence, core::Duration limit,
                                                       std::function<bool()> seen);
    [[nodiscard]] core::Task<core::Result<void>> pause(core::Duration span);
    [[nodiscard]] core::Task<core::Result<void>> settle();  ///< layouts and queued signals are through
    [[nodiscard]] core::Task<core::Result<void>>
    freshFrame();  ///< a frame with pointing, taken after this call, is on screen

    /// Where the mark is in the frame shown now: predicted by the rig, then found in the picture to
    /// sub-pixels.
    [[nodiscard]] std::optional<QPointF> markPixel(const KnownMark& mark) const;

private:
    void save(const QPixmap& picture, const QString& name) const;

    MainWindow& window_;
    app::Workbench& bench_;
    QString folder_;
    core::SystemClock clock_;
};

}  // namespace pmts::gui
