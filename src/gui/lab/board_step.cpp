#include "board_step.hpp"

#include "calibration_pdf.hpp"
#include "parts/lab_parts.hpp"
#include "pmts/gui/theme.hpp"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QListWidget>
#include <QPainter>
#include <QPlainTextEdit>
#include <QSignalBlocker>

namespace pmts::gui {
namespace {

constexpr int kFewestViews = 4;

}  // namespace

BoardStep::BoardStep(app::BoardPresenter& board, QWidget* parent) : LabStep(parent), board_(board) {
    auto* const column = new QVBoxLayout(this);
    addPattern(*column);
    sentence_ = labText("board_sentence", this);
    look_ = labButton(tr("Take views"), "board_look", this);
    look_->setCheckable(true);
    views_ = new QListWidget(this);
    views_->setObjectName(QStringLiteral("board_views"));
    views_->setAccessibleName(tr("Views of the board"));
    views_->setMinimumHeight(110);
    auto* const remove = labButton(tr("Remove view"), "board_remove", this);
    auto* const clear = labButton(tr("Clear"), "board_clear", this);
    auto* const folder = labButton(tr("Pictures of a folder…"), "board_folder", this);
    calibrate_ = labButton(tr("Calibrate"), "board_calibrate", this);
    verdict_ = labText("board_verdict", this);
    result_ = new QPlainTextEdit(this);
    result_->setReadOnly(true);
    result_->setMinimumHeight(130);
    result_->setAccessibleName(tr("Result"));
    accept_ = labButton(tr("Use this lens, keep the mount"), "board_accept", this);
    auto* const grid = new QGridLayout;
    grid->addWidget(look_, 0, 0);
    grid->addWidget(calibrate_, 0, 1);
    auto* const more = new QGridLayout;
    more->addWidget(remove, 0, 0);
    more->addWidget(clear, 0, 1);
    more->addWidget(folder, 1, 0, 1, 2);
    column->addWidget(sentence_);
    column->addLayout(grid);
    column->addWidget(views_);
    column->addLayout(more);
    column->addWidget(verdict_);
    column->addWidget(result_);
    column->addWidget(accept_);
    column->addStretch(1);
    connect(look_, &QPushButton::toggled, &board_, &app::BoardPresenter::setLooking);
    connect(calibrate_, &QPushButton::clicked, &board_, &app::BoardPresenter::calibrate);
    connect(accept_, &QPushButton::clicked, &board_, &app::BoardPresenter::acceptLens);
    connect(clear, &QPushButton::clicked, &board_, &app::BoardPresenter::clear);
    connect(remove, &QPushButton::clicked, this, [this] { board_.removeView(views_->currentRow()); });
    connect(folder, &QPushButton::clicked, this, [this] {
        const QString path = QFileDialog::getExistingDirectory(this, tr("Pictures of the board"));
        if (!path.isEmpty()) {
            board_.calibrateFolder(path);
        }
    });
    connect(&board_, &app::BoardPresenter::changed, this, &BoardStep::showAll);
    showAll();
}

void BoardStep::addPattern(QVBoxLayout& column) {
    kind_ = new QComboBox(this);
    kind_->setMinimumHeight(ActionButton::kLeastSide_px);
    kind_->setAccessibleName(tr("Kind of board"));
    kind_->addItem(tr("Chessboard"), QString());
    for (const QString& name : app::BoardPresenter::dictionaries()) {
        kind_->addItem(tr("ChArUco %1").arg(name), name);
    }
    const auto count = [this](const QString& name) {
        auto* const box = new QSpinBox(this);
        box->setRange(3, 60);
        box->setMinimumHeight(ActionButton::kLeastSide_px);
        box->setAccessibleName(name);
        return box;
    };
    columns_ = count(tr("Inner corners across"));
    rows_ = count(tr("Inner corners down"));
    square_mm_ = new QDoubleSpinBox(this);
    square_mm_->setRange(1, 1000);
    square_mm_->setDecimals(2);
    square_mm_->setSuffix(tr(" mm"));
    square_mm_->setMinimumHeight(ActionButton::kLeastSide_px);
    square_mm_->setAccessibleName(tr("Side of a square"));
    auto* const print_button = labButton(tr("Print a board…"), "board_print", this);
    connect(print_button, &QPushButton::clicked, this, &BoardStep::print);
    auto* const grid = new QGridLayout;
    grid->addWidget(kind_, 0, 0, 1, 2);
    grid->addWidget(new QLabel(tr("Inner corners"), this), 1, 0);
    auto* const corners = new QHBoxLayout;
    corners->addWidget(columns_, 1);
    corners->addWidget(new QLabel(QStringLiteral("×"), this));
    corners->addWidget(rows_, 1);
    grid->addLayout(corners, 1, 1);
    grid->addWidget(new QLabel(tr("Square"), this), 2, 0);
    grid->addWidget(square_mm_, 2, 1);
    grid->addWidget(print_button, 3, 0, 1, 2);
    grid->setColumnStretch(1, 1);
    column.addLayout(grid);
    connect(kind_, &QComboBox::activated, this, &BoardStep::takePattern);
    connect(columns_, &QSpinBox::editingFinished, this, &BoardStep::takePattern);
    connect(rows_, &QSpinBox::editingFinished, this, &BoardStep::takePattern);
    connect(square_mm_, &QDoubleSpinBox::editingFinished, this, &BoardStep::takePattern);
}

void BoardStep::takePattern() {
    auto pattern = board_.pattern();
    pattern.columns = columns_->value();
    pattern.rows = rows_->value();
    pattern.square_m = square_mm_->value() / 1000;
    pattern.dictionary = kind_->currentData().toString();
    board_.setPattern(pattern);
}

void BoardStep::left() { board_.setLooking(false); }

void BoardStep::showAll() {
    const QSignalBlocker q1(kind_), q2(columns_), q3(rows_), q4(square_mm_), q5(look_);
    if (!columns_->hasFocus() && !rows_->hasFocus() && !square_mm_->hasFocus()) {
        kind_->setCurrentIndex(std::max(0, kind_->findData(board_.pattern().dictionary)));
        columns_->setValue(board_.pattern().columns);
        rows_->setValue(board_.pattern().rows);
        square_mm_->setValue(board_.pattern().square_m * 1000);
    }
    look_->setChecked(board_.isLooking());
    look_->setText(board_.isLooking() ? tr("Stop taking") : tr("Take views"));
    sentence_->setText(board_.sentence().isEmpty() ? tr("A printed board as a second opinion on the lens. At least %1 views, tilted to all sides.").arg(kFewestViews)
                                                   : board_.sentence());
    if (views_->count() != static_cast<int>(board_.views().size())) {
        views_->clear();
        for (const auto& view : board_.views()) {
            views_->addItem(tr("%1: %2 corners, sharpness %3").arg(view.name).arg(view.px.size()).arg(view.sharpness, 0, 'f', 2));
        }
    }
    calibrate_->setEnabled(static_cast<int>(board_.views().size()) >= kFewestViews && !board_.isAdjusting());
    verdict_->setText(board_.verdict());
    verdict_->setVisible(board_.result().has_value());
    result_->setVisible(board_.result().has_value());
    accept_->setVisible(board_.result().has_value());
    if (result_->toPlainText() != board_.resultText()) {
        result_->setPlainText(board_.resultText());
    }
    Q_EMIT stateChanged(board_.isAdjusting() ? app::DeviceState::kBusy : board_.verdictState());
    Q_EMIT overlayChanged();
}

void BoardStep::paintOver(QPainter& painter, const QTransform& widget_from_frame) {
    const Theme& theme = currentTheme();
    const auto corners = [&](const std::vector<Eigen::Vector2d>& px, const QColor& colour, double radius) {
        for (const auto& [pen_colour, width] : {std::pair(QColor(Qt::black), 4.0), std::pair(colour, 2.0)}) {
            painter.setPen(QPen(pen_colour, width));
            for (const Eigen::Vector2d& at : px) {
                painter.drawEllipse(widget_from_frame.map(QPointF(at.x(), at.y())), radius, radius);
            }
        }
    };
    painter.setBrush(Qt::NoBrush);
    for (const auto& view : board_.views()) {
        corners(view.px, QColor(Qt::white), 1.0);
    }
    if (board_.isLooking() && board_.seen()) {
        corners(board_.seen()->px, theme.accent, 4.0);
    }
}

void BoardStep::print() {
    const auto sheet = board_.sheet();
    if (!sheet) {
        sentence_->setText(sheet.error().sentence());
        return;
    }
    const QString path = QFileDialog::getSaveFileName(this, tr("Print a board"), QStringLiteral("board.pdf"), tr("PDF (*.pdf)"));
    if (!path.isEmpty()) {
        const auto written = writeBoardPdf(sheet->cells, sheet->cell_mm, sheet->caption, path);
        sentence_->setText(written ? tr("Print it at 100 %, glue it on something flat, measure a square.") : written.error().sentence());
    }
}

}  // namespace pmts::gui
