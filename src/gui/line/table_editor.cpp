#include "table_editor.hpp"

#include "pmts/gui/theme.hpp"

#include <QFontDatabase>
#include <QHelpEvent>
#include <QPainter>
#include <QTextBlock>
#include <QToolTip>

#include <utility>

namespace pmts::gui {
namespace {

constexpr int kBesideNumber_px = 8;
constexpr int kMark_px = 14;

/// The strip of line numbers.
class Margin : public QWidget {
public:
    explicit Margin(TableEditor& editor) : QWidget(&editor), editor_(editor) {}
    [[nodiscard]] QSize sizeHint() const override { return {editor_.marginWidth(), 0}; }

protected:
    void paintEvent(QPaintEvent* event) override { editor_.paintMargin(*event); }

private:
    TableEditor& editor_;
};

}  // namespace

TableEditor::TableEditor(QWidget* parent) : QPlainTextEdit(parent), margin_(new Margin(*this)) {
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    setLineWrapMode(QPlainTextEdit::NoWrap);
    setTabChangesFocus(true);
    connect(this, &QPlainTextEdit::blockCountChanged, this, &TableEditor::makeRoom);
    connect(this, &QPlainTextEdit::updateRequest, margin_, [this](const QRect& area, int scrolled) {
        scrolled == 0 ? margin_->update(0, area.y(), margin_->width(), area.height()) : margin_->scroll(0, scrolled);
    });
    makeRoom();
}

int TableEditor::marginWidth() const {
    const auto digits = static_cast<int>(QString::number(std::max(99, blockCount())).size());
    return kMark_px + digits * fontMetrics().horizontalAdvance(u'9') + kBesideNumber_px;
}

void TableEditor::makeRoom() {
    setViewportMargins(marginWidth(), 0, 0, 0);
    const QRect inside = contentsRect();
    margin_->setGeometry(inside.left(), inside.top(), marginWidth(), inside.height());
}

void TableEditor::resizeEvent(QResizeEvent* event) {
    QPlainTextEdit::resizeEvent(event);
    makeRoom();
}

void TableEditor::changeEvent(QEvent* event) {
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::FontChange) {
        makeRoom();
    } else if (event->type() == QEvent::StyleChange || event->type() == QEvent::PaletteChange) {
        markProblems();
    }
}

void TableEditor::paintMargin(QPaintEvent& event) {
    const Theme& theme = currentTheme();
    QPainter painter(margin_);
    painter.setFont(font());
    painter.fillRect(event.rect(), theme.panel);
    for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
        const QRectF place = blockBoundingGeometry(block).translated(contentOffset());
        if (place.top() > event.rect().bottom()) {
            break;
        }
        const int line = block.blockNumber() + 1;
        const QRectF number(0, place.top(), margin_->width() - kBesideNumber_px, place.height());
        if (problems_.contains(line)) {
            painter.setPen(theme.failed);
            painter.drawText(QRectF(0, place.top(), kMark_px, place.height()), Qt::AlignCenter, QStringLiteral("!"));
        }
        painter.setPen(theme.muted);
        painter.drawText(number, Qt::AlignRight | Qt::AlignVCenter, QString::number(line));
    }
}

void TableEditor::setProblems(std::map<int, QString> sentences) {
    problems_ = std::move(sentences);
    markProblems();
    margin_->update();
}

void TableEditor::markProblems() {
    QList<QTextEdit::ExtraSelection> marks;
    for (const auto& [line, sentence] : problems_) {
        const QTextBlock block = document()->findBlockByNumber(line - 1);
        if (!block.isValid()) {
            continue;
        }
        QTextEdit::ExtraSelection mark;
        mark.cursor = QTextCursor(block);
        mark.cursor.select(QTextCursor::LineUnderCursor);
        mark.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
        mark.format.setUnderlineColor(currentTheme().failed);
        marks.append(mark);
    }
    setExtraSelections(marks);
}

void TableEditor::jumpTo(int line) {
    const QTextBlock block = document()->findBlockByNumber(line - 1);
    if (block.isValid()) {
        setTextCursor(QTextCursor(block));
        centerCursor();
        setFocus();
    }
}

bool TableEditor::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) {
        return QPlainTextEdit::event(event);
    }
    const auto& help = static_cast<const QHelpEvent&>(*event);
    const int line = cursorForPosition(viewport()->mapFrom(this, help.pos())).blockNumber() + 1;
    const auto found = problems_.find(line);
    QToolTip::showText(help.globalPos(), found == problems_.end() ? QString() : found->second, this);
    return true;
}

}  // namespace pmts::gui
