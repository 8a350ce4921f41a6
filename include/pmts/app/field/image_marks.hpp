#pragma once

#include "pmts/geometry/pointing.hpp"

#include <QObject>
#include <QPointF>
#include <QString>

#include <vector>

namespace pmts::app {

/// A mark somebody drew into a picture (routine Pdraw): a direction with the range it was drawn for.
struct ImageMark {
    qint64 id = 0;  ///< 0 before it is added
    QString label;
    geometry::Pointing pointing;
    double slope_distance_m = 0.0;
    qint64 photo_row_id = 0;  ///< still it was drawn on; 0: the live picture, or a still the job does not have
    QPointF photo_px;         ///< where on that still
};

/// The marks of the open job.
class ImageMarks : public QObject {
    Q_OBJECT
public:
    explicit ImageMarks(QObject* parent = nullptr);

    [[nodiscard]] const std::vector<ImageMark>& marks() const { return marks_; }
    [[nodiscard]] const ImageMark* find(qint64 id) const;
    /// An empty label becomes the next free `M1`, `M2`, ...
    qint64 add(ImageMark mark);
    void rename(qint64 id, const QString& label);
    /// The same mark at another place.
    void move(qint64 id, const ImageMark& place);
    void remove(qint64 id);
    void clear();

Q_SIGNALS:
    void changed();  ///< after any of the others, and after clear()
    void added(const pmts::app::ImageMark& mark);
    void edited(const pmts::app::ImageMark& mark);
    void removed(qint64 id);

private:
    [[nodiscard]] ImageMark* findToChange(qint64 id);
    [[nodiscard]] QString nextLabel() const;

    std::vector<ImageMark> marks_;
    qint64 last_id_ = 0;
};

}  // namespace pmts::app
