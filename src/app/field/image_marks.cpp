#include "pmts/app/field/image_marks.hpp"

#include <algorithm>

namespace pmts::app {

ImageMarks::ImageMarks(QObject* parent) : QObject(parent) {}

const ImageMark* ImageMarks::find(qint64 id) const {
    const auto found = std::ranges::find(marks_, id, &ImageMark::id);
    return found != marks_.end() ? &*found : nullptr;
}

ImageMark* ImageMarks::findToChange(qint64 id) {
    const auto found = std::ranges::find(marks_, id, &ImageMark::id);
    return found != marks_.end() ? &*found : nullptr;
}

QString ImageMarks::nextLabel() const {
    for (int number = 1;; ++number) {
        const QString label = tr("M%1").arg(number);
        if (std::ranges::find(marks_, label, &ImageMark::label) == marks_.end()) {
            return label;
        }
    }
}

qint64 ImageMarks::add(ImageMark mark) {
    mark.id = ++last_id_;
    mark.label = mark.label.trimmed().isEmpty() ? nextLabel() : mark.label.trimmed();
    const qint64 id = mark.id;
    marks_.push_back(mark);
    Q_EMIT added(mark);
    Q_EMIT changed();
    return id;
}

void ImageMarks::rename(qint64 id, const QString& label) {
    ImageMark* const mark = findToChange(id);
    if (mark != nullptr && !label.trimmed().isEmpty() && label.trimmed() != mark->label) {
        mark->label = label.trimmed();
        Q_EMIT edited(*mark);
        Q_EMIT changed();
    }
}

void ImageMarks::move(qint64 id, const ImageMark& place) {
    if (ImageMark* const mark = findToChange(id)) {
        const QString label = mark->label;
        *mark = place;
        mark->id = id;
        mark->label = label;
        Q_EMIT edited(*mark);
        Q_EMIT changed();
    }
}

void ImageMarks::remove(qint64 id) {
    if (std::erase_if(marks_, [id](const ImageMark& mark) { return mark.id == id; }) != 0) {
        Q_EMIT removed(id);
        Q_EMIT changed();
    }
}

void ImageMarks::clear() {
    if (!marks_.empty()) {
        marks_.clear();
        Q_EMIT changed();
    }
}

}  // namespace pmts::app
