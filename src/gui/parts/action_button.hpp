#pragma once

#include <QToolButton>

namespace pmts::gui {

/// A big button of the bottom bar: icon, name, and below the name the one key that does the same.
/// Takes everything from its default action; at least 44 px high and wide.
class ActionButton : public QToolButton {
    Q_OBJECT
public:
    enum class Weight { kPlain, kMain, kStop };
    static constexpr int kLeastSide_px = 44;

    explicit ActionButton(QWidget* parent = nullptr);

    void setAction(QAction* action, Weight weight = Weight::kPlain);
    void setIconOnly(bool icon_only);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] QString keyText() const;
    [[nodiscard]] QFont nameFont() const;
    [[nodiscard]] QFont keyFont() const;
    [[nodiscard]] int textWidth() const;
    void paintIcon(QPainter& painter, const QRect& place, const QColor& ink) const;
    void paintGround(QPainter& painter, const QColor& ground, const QColor& ink) const;
    void paintName(QPainter& painter, const QRect& place, const QColor& ink) const;

    Weight weight_ = Weight::kPlain;
    bool icon_only_ = false;
};

/// A key as it stands on the keyboard: `Enter`, `Space`, `C`, an arrow.
[[nodiscard]] QString keyCapText(const QKeySequence& key);

}  // namespace pmts::gui
