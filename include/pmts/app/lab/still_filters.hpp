#pragma once

#include "pmts/camera/frame.hpp"
#include "pmts/camera/image_filters.hpp"
#include "pmts/core/result.hpp"

#include <QObject>

#include <map>

namespace pmts::app {

/// The filter of each still, by its number. Pixels are never changed: shown() makes a copy for the eye, clicks and snaps work
/// on the frame itself.
class StillFilters : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    [[nodiscard]] camera::ImageFilter of(int still_number) const;
    /// The frame as it is to be shown; the frame itself when it has no filter. Kept until the filter or the frame is another.
    [[nodiscard]] camera::FramePtr shown(int still_number, const camera::FramePtr& frame) const;
    /// As PNG or JPEG by its name; kFile when it cannot be written.
    [[nodiscard]] core::Result<void> write(int still_number, const camera::FramePtr& frame, const QString& path) const;

public Q_SLOTS:
    void set(int still_number, const pmts::camera::ImageFilter& filter);

Q_SIGNALS:
    void changed(int still_number);

private:
    std::map<int, camera::ImageFilter> filters_;
    mutable int made_for_ = 0;
    mutable camera::ImageFilter made_with_;
    mutable camera::FramePtr made_of_, made_;
};

}  // namespace pmts::app
