#include "pmts/app/lab/still_filters.hpp"

#include "pmts/app/desk/frame_image.hpp"

#include <QCoreApplication>
#include <QImage>

namespace pmts::app {

camera::ImageFilter StillFilters::of(int still_number) const {
    const auto found = filters_.find(still_number);
    return found == filters_.end() ? camera::ImageFilter{} : found->second;
}

void StillFilters::set(int still_number, const camera::ImageFilter& filter) {
    if (of(still_number) == filter) {
        return;
    }
    if (filter.isNone()) {
        filters_.erase(still_number);
    } else {
        filters_[still_number] = filter;
    }
    Q_EMIT changed(still_number);
}

camera::FramePtr StillFilters::shown(int still_number, const camera::FramePtr& frame) const {
    const camera::ImageFilter filter = of(still_number);
    if (!frame || filter.isNone()) {
        return frame;
    }
    if (made_of_ != frame || made_for_ != still_number || !(made_with_ == filter)) {
        auto copy = std::make_shared<camera::Frame>(*frame);
        copy->image = camera::filtered(frame->image, filter);
        made_ = copy;
        made_of_ = frame;
        made_for_ = still_number;
        made_with_ = filter;
    }
    return made_;
}

core::Result<void> StillFilters::write(int still_number, const camera::FramePtr& frame, const QString& path) const {
    if (!frame || !imageOfFrame(shown(still_number, frame)).save(path)) {
        return core::fail(core::ErrorKind::kFile, QCoreApplication::translate("StillFilters", "The picture cannot be written."),
                          QCoreApplication::translate("StillFilters", "Choose another folder, and a name ending in .png or .jpg."), path);
    }
    return {};
}

}  // namespace pmts::app
