#pragma once

#include "pmts/app/field/evidence_presenter.hpp"

#include <QWidget>

namespace pmts::gui {

/// One picture of an aiming, as large as its room allows, with reticle and spot.
class ThumbnailView : public QWidget {
    Q_OBJECT
public:
    explicit ThumbnailView(QWidget* parent = nullptr);

    void showThumbnail(const app::EvidenceThumbnail& thumbnail);

    [[nodiscard]] QSize sizeHint() const override { return {460, 259}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {400, 225}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    app::EvidenceThumbnail thumbnail_;
};

}  // namespace pmts::gui
