#pragma once

#include "pmts/app/desk/device_state.hpp"

#include <QWidget>

namespace pmts::gui {

/// A page that a list at the left of its workspace opens (PageList).
class ListedPage : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    [[nodiscard]] virtual QString title() const = 0;  ///< one or two words in the list
    virtual void entered();                           ///< it is shown now
    virtual void left();                              ///< another page or workspace is shown

Q_SIGNALS:
    void stateChanged(pmts::app::DeviceState state);  ///< lamp beside the title
};

}  // namespace pmts::gui
