#include "pmts/targeting/patch_ahead.hpp"

#include <QThreadPool>

namespace pmts::targeting {

void PatchAhead::begin(camera::FramePtr frame, const Eigen::Vector2d& click_px) {
    slot_ = std::make_shared<Slot>();
    slot_->frame = std::move(frame);
    slot_->click_px = click_px;
    if (!slot_->frame) {
        return;
    }
    QThreadPool::globalInstance()->start([slot = slot_, matcher = matcher_] {
        const auto patch = matcher.take(slot->frame->image, slot->click_px);
        if (patch) {
            const std::lock_guard lock(slot->mutex);
            slot->patch = *patch;
        }
    });
}

std::optional<Patch> PatchAhead::taken(const camera::FramePtr& frame, const Eigen::Vector2d& click_px) const {
    if (!slot_ || slot_->frame != frame || slot_->click_px != click_px) {
        return std::nullopt;
    }
    const std::lock_guard lock(slot_->mutex);
    return slot_->patch;
}

}  // namespace pmts::targeting
