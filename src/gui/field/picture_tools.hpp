#pragma once

#include <QObject>

namespace pmts::gui {

class FieldActions;

/// The tool in hand, one for all pictures. Without one a click aims.
class PictureTools : public QObject {
    Q_OBJECT
public:
    enum class Tool { kAim, kDragTurn, kZoomBox, kMark };

    explicit PictureTools(const FieldActions& actions, QObject* parent = nullptr);

    [[nodiscard]] Tool tool() const { return tool_; }
    void putAway();  ///< back to aiming
    void touch(const QObject& by) { Q_EMIT touched(&by); }

Q_SIGNALS:
    void toolChanged(pmts::gui::PictureTools::Tool tool);
    void touched(const QObject* by);  ///< what all others offer beside their points is over

private:
    void take(Tool tool);

    const FieldActions& actions_;
    Tool tool_ = Tool::kAim;
};

}  // namespace pmts::gui
