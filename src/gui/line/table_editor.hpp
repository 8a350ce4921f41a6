#pragma once

#include <QPlainTextEdit>

#include <map>

namespace pmts::gui {

/// A text with its line numbers; lines with a problem are marked by shape and colour, the sentence is in their tool tip.
class TableEditor : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit TableEditor(QWidget* parent = nullptr);

    void setProblems(std::map<int, QString> sentences);  ///< by line, from 1
    void jumpTo(int line);

    void paintMargin(QPaintEvent& event);
    [[nodiscard]] int marginWidth() const;

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void makeRoom();
    void markProblems();

    QWidget* margin_;
    std::map<int, QString> problems_;
};

}  // namespace pmts::gui
