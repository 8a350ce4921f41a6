#pragma once

#include "pmts/app/field/evidence_shots.hpp"
#include "pmts/app/desk/live_presenter.hpp"
#include "pmts/app/field/targeting_presenter.hpp"

#include <optional>

namespace pmts::app {

/// What the pictures say about a shot when it is made: how the telescope was put there, with a thumbnail of the click
/// and one of what it points at now.
class EvidenceCollector {
public:
    EvidenceCollector(const TargetingPresenter& targeting, const LivePresenter& live, const Preferences& preferences,
                      const core::Clock& clock);

    /// Absent without a camera. A shot that no click led to is kept as aimed by eye, with its picture.
    [[nodiscard]] std::optional<EvidenceShots> collect(const geometry::Pointing& shot) const;

private:
    [[nodiscard]] const Target* targetOf(const geometry::Pointing& shot) const;
    void addClick(EvidenceShots& shots, const Target& target) const;
    void addProof(EvidenceShots& shots, const targeting::Recentred& proof) const;
    void addPicture(EvidenceShots& shots, const geometry::Pointing& shot) const;

    const TargetingPresenter& targeting_;
    const LivePresenter& live_;
    const Preferences& preferences_;
    const core::Clock& clock_;
};

}  // namespace pmts::app
