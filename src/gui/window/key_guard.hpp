#pragma once

#include <QObject>

#include <functional>

namespace pmts::gui {

/// Decides whose a key is. While a field is being typed in, the single keys are letters; while a table has
/// the focus, the arrows and Enter walk in it; everywhere, in every window, Esc stops the instrument first as
/// long as it moves.
class KeyGuard : public QObject {
    Q_OBJECT
public:
    /// `stop_if_moving` returns true when there was something to stop.
    explicit KeyGuard(std::function<bool()> stop_if_moving, QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::function<bool()> stop_if_moving_;
    bool swallow_escape_ = false;
};

}  // namespace pmts::gui
