#include "pmts/app/field/aiming_presenter.hpp"

#include "app/field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

class AimingPresenterTest : public FieldTest {
protected:
    AimingPresenter aiming{preferences, instrument, station_page, clock};
    QSignalSpy refused{&aiming, &AimingPresenter::fieldRejected};
};

TEST_F(AimingPresenterTest, WhatIsTypedInAnyUnitIsKept) {
    AimingForm form = aiming.form();
    form.method = static_cast<int>(targeting::Method::kOatpa);
    form.tolerance = QStringLiteral("30\"");
    form.highest = QStringLiteral("9°");
    form.has_sector = true;
    form.sector_from = QStringLiteral("350 gon");
    form.sector_to = QStringLiteral("45°");
    aiming.apply(form);
    EXPECT_EQ(refused.size(), 0);
    const AimingSettings& kept = preferences.settings().aiming;
    EXPECT_EQ(kept.method, targeting::Method::kOatpa);
    EXPECT_NEAR(kept.tolerance.arcsec(), 30.0, 1e-9);
    EXPECT_NEAR(kept.limits.highest.gon(), 10.0, 1e-9);
    ASSERT_TRUE(kept.limits.ha_sector.has_value());
    EXPECT_NEAR(kept.limits.ha_sector->second.gon(), 50.0, 1e-9);
}

TEST_F(AimingPresenterTest, FormGoesRoundWithoutChange) {
    Settings settings = preferences.settings();
    settings.aiming.place = targeting::Place{Angle::fromDeg(60.17), Angle::fromDeg(24.94)};
    settings.aiming.avoids_sun = true;
    settings.aiming.most_wound = Angle::fromGon(600);
    preferences.set(settings);
    aiming.apply(aiming.form());
    const AimingSettings& kept = preferences.settings().aiming;
    EXPECT_NEAR(kept.place.value().latitude.deg(), 60.17, 1e-4);
    EXPECT_NEAR(kept.most_wound.value().gon(), 600.0, 1e-9);
    EXPECT_TRUE(kept.avoids_sun);
}

TEST_F(AimingPresenterTest, FieldThatCannotBeReadChangesNothingAndIsNamed) {
    AimingForm form = aiming.form();
    form.method = static_cast<int>(targeting::Method::kApa);
    form.tolerance_px = QStringLiteral("0");
    form.tolerance = QStringLiteral("small");
    aiming.apply(form);
    ASSERT_EQ(refused.size(), 1) << "the first wrong field is enough";
    EXPECT_EQ(refused[0][0].value<AimingField>(), AimingField::kTolerancePx);
    EXPECT_EQ(preferences.settings().aiming.method, targeting::Method::kRigorous);
}

TEST_F(AimingPresenterTest, SunNeedsAPlace) {
    AimingForm form = aiming.form();
    form.avoids_sun = true;
    aiming.apply(form);
    ASSERT_EQ(refused.size(), 1);
    EXPECT_EQ(refused[0][0].value<AimingField>(), AimingField::kLatitude);
    EXPECT_THAT(aiming.sunText().toStdString(), testing::HasSubstr("not watched"));
}

TEST_F(AimingPresenterTest, CableSaysHowFarItIsWoundUntilItHangsFree) {
    connectInstrument();
    ASSERT_TRUE(turnTo(120, 100));
    EXPECT_THAT(aiming.cableText().toStdString(), testing::HasSubstr("0.3"));
    EXPECT_THAT(aiming.cableText().toStdString(), testing::HasSubstr("right"));
    aiming.cableHangsFree();
    core::deliverQueuedEvents();
    EXPECT_THAT(aiming.cableText().toStdString(), testing::HasSubstr("0.00"));
}

}  // namespace
}  // namespace pmts::app
