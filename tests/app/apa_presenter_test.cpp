#include "pmts/app/field/apa_presenter.hpp"

#include "app/field_fixture.hpp"

#include <QSignalSpy>

namespace pmts::app {
namespace {

/// Four places on the wall 15 m away, near the edges of a still taken at HA 0, VA 100.
class ApaPresenterTest : public FieldTest {
protected:
    void SetUp() override {
        connectInstrument();
        ASSERT_TRUE(turnTo(0, 100));
        showFrames();
        apa.capture();
        showFrames(4);
        ASSERT_TRUE(apa.still().has_value());
        range.addShot({Angle(), Angle::fromGon(100)}, 15.0);
    }
    static geometry::Pointing placeOf(Extreme which) {
        switch (which) {
            case Extreme::kLeft: return {Angle::fromGon(385), Angle::fromGon(100)};
            case Extreme::kRight: return {Angle::fromGon(15), Angle::fromGon(100)};
            case Extreme::kUpper: return {Angle::fromGon(0), Angle::fromGon(92)};
            case Extreme::kLower: return {Angle::fromGon(0), Angle::fromGon(108)};
        }
        return {};
    }
    /// Where the camera sees it, `wider` times as far from the middle.
    QPointF pixelAt(Extreme which, double wider = 1.0) const {
        const auto px = live.model().pixelForPoint(
            geometry::stationFromPolar({placeOf(which), 15.0}), apa.still()->pointing);
        const QPointF middle(live.model().rig().width_px / 2.0, live.model().rig().height_px / 2.0);
        return middle + (QPointF(px->x(), px->y()) - middle) * wider;
    }
    void measureAll(double wider = 1.0) {
        for (const Extreme which : {Extreme::kLeft, Extreme::kRight, Extreme::kUpper, Extreme::kLower}) {
            ASSERT_EQ(apa.current(), which);
            apa.click(pixelAt(which, wider));
            ASSERT_TRUE(turnTo(placeOf(which).ha.gon(), placeOf(which).va.gon()));
            pass(500ms);
            apa.takeReading();
        }
    }

    ApaPresenter apa{live, instrument, preferences, messages};
    QSignalSpy refused{&apa, &ApaPresenter::refused};
};

TEST_F(ApaPresenterTest, FourObjectsGiveTheAngleOfAPixelAcrossAndDown) {
    measureAll();
    EXPECT_TRUE(refused.empty());
    ASSERT_TRUE(apa.canStore());
    EXPECT_EQ(apa.across().state, DeviceState::kGood) << apa.across().judgement.toStdString();
    EXPECT_EQ(apa.down().state, DeviceState::kGood) << apa.down().judgement.toStdString();
    const double columns_px = pixelAt(Extreme::kRight).x() - pixelAt(Extreme::kLeft).x();
    EXPECT_NEAR(apa.across().per_pixel.section(u' ', 0, 0).toDouble(), 30.0 / columns_px, 2e-5);  // 1 mgon of servo
}

TEST_F(ApaPresenterTest, ResultOfOneDirectionIsShownBeforeTheOther) {
    apa.click(pixelAt(Extreme::kLeft));
    EXPECT_TRUE(apa.across().pixels.isEmpty());
    apa.takeReading();
    apa.click(pixelAt(Extreme::kRight));
    EXPECT_FALSE(apa.across().pixels.isEmpty());
    EXPECT_TRUE(apa.across().per_pixel.isEmpty());
    ASSERT_TRUE(turnTo(15, 100));
    pass(500ms);
    apa.takeReading();
    EXPECT_FALSE(apa.across().per_pixel.isEmpty());
    EXPECT_FALSE(apa.canStore());
}

TEST_F(ApaPresenterTest, MeasurementFarFromTheRigsOwnAngleIsDoubted) {
    measureAll(1.1);  // ten per cent more pixels between the same objects
    EXPECT_EQ(apa.across().state, DeviceState::kWarning);
    EXPECT_THAT(apa.across().judgement.toStdString(), testing::HasSubstr("less than the rig says"));
    EXPECT_TRUE(apa.canStore());  // the surveyor decides
}

TEST_F(ApaPresenterTest, ReadingIsRefusedWhileTheTelescopeMoves) {
    targeting.aimAtText(QStringLiteral("100"), QStringLiteral("95"));
    targeting.move();
    ASSERT_TRUE(until([this] { return targeting.target()->state == MoveState::kTurning; }));
    apa.takeReading();
    ASSERT_EQ(refused.size(), 1);
    EXPECT_THAT(refused.at(0).at(0).toString().toStdString(), testing::HasSubstr("stands still"));
    EXPECT_FALSE(apa.object(Extreme::kLeft).reading.has_value());
}

TEST_F(ApaPresenterTest, ReadingWithoutAnInstrumentIsRefused) {
    instrument.disconnectInstrument();
    ASSERT_TRUE(until([this] { return instrument.connectionState() == ConnectionState::kDisconnected; }));
    apa.takeReading();
    EXPECT_EQ(refused.size(), 1);
}

TEST_F(ApaPresenterTest, StoredAngleIsThatOfTheChosenRig) {
    apa.store();
    EXPECT_EQ(refused.size(), 1) << "nothing measured yet";
    measureAll();
    apa.store();
    const auto kept = preferences.settings().chosenRig().average_pixel_angle;
    ASSERT_TRUE(kept.has_value());
    EXPECT_NEAR(kept->horizontal.gon() * (pixelAt(Extreme::kRight).x() - pixelAt(Extreme::kLeft).x()), 30.0, 0.01);
    EXPECT_GT(kept->vertical.gon(), 0);
}

TEST_F(ApaPresenterTest, StillTakenElsewhereDoesNotDisturbTheMeasurement) {
    apa.click(pixelAt(Extreme::kLeft));
    live.capture();
    showFrames(4);
    EXPECT_EQ(apa.still()->number, 1);
    EXPECT_TRUE(apa.object(Extreme::kLeft).px.has_value());
}

TEST_F(ApaPresenterTest, NewStillStartsOver) {
    apa.click(pixelAt(Extreme::kLeft));
    apa.choose(Extreme::kLower);
    apa.capture();
    showFrames(4);
    EXPECT_EQ(apa.still()->number, 2);
    EXPECT_FALSE(apa.object(Extreme::kLeft).px.has_value());
    EXPECT_EQ(apa.current(), Extreme::kLeft);
}

}  // namespace
}  // namespace pmts::app
