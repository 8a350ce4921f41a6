#pragma once

#include <QFrame>

#include <functional>
#include <vector>

class QHBoxLayout;
class QLineEdit;

namespace pmts::gui {

/// A small box beside something in a picture that was clicked: what can be done with it, in buttons for
/// gloves. Goes when something is chosen, the picture is left to something else, or the surveyor clicks
/// elsewhere.
class PictureCallout : public QFrame {
    Q_OBJECT
public:
    struct Choice {
        QString text;
        std::function<void()> act;
    };

    explicit PictureCallout(QWidget* picture);

    void offer(const QPointF& at, std::vector<Choice> choices);
    /// The same with a field for the name; `rename` hears the text when Enter is pressed or the field is
    /// left.
    void offerWithName(const QPointF& at, const QString& name, std::function<void(const QString&)> rename,
                       std::vector<Choice> choices);

private:
    void empty();
    void addButtons(std::vector<Choice> choices);
    void showBeside(const QPointF& at);

    QHBoxLayout* row_;
};

}  // namespace pmts::gui
