#include "pmts/targeting/method_report.hpp"

#include "support/matchers.hpp"

namespace pmts::targeting {
namespace {

using core::Angle;

std::vector<ListedTarget> thesisTargets() { return readTargetFile(PMTS_TEST_DATA "/icsm.csv").value(); }

/// The camera that explains the thesis's photo (PMTS reference, section 9).
FittedRig fittedRig() {
    FittedRig fit;
    fit.rig.lens =
        camera::Lens(camera::BrownLens{.f_px = 762.321, .cx_px = 315.922, .cy_px = 148.475, .k1 = -0.308047});
    fit.rig.mount = {.kind = camera::MountKind::kHandle,
                     .offset_m = {0, 0.1259, -0.0317939},
                     .pitch = Angle::fromRad(0.0263438)};
    fit.rms_px = 0.38;
    fit.largest_px = 0.78;
    fit.parameters = {"f [px] 762.3 +- 1.6"};
    return fit;
}

const MethodTable& tableOf(const std::vector<MethodTable>& tables, Method method) {
    return *std::find_if(tables.begin(), tables.end(),
                         [method](const MethodTable& t) { return t.method == method; });
}

TEST(MethodReportTest, PrintedTablesOfTheThesisAreReproduced) {
    const auto tables = runMethods(thesisTargets(), {});
    EXPECT_LE(tableOf(tables, Method::kApa).off_printed->gon(), 0.001);
    EXPECT_LE(tableOf(tables, Method::kTpa).off_printed->gon(), 0.010);
    EXPECT_LE(tableOf(tables, Method::kOatpa).off_printed->gon(), 0.010);
}

TEST(MethodReportTest, ErrorsAreThoseTheReferenceStates) {
    const auto tables = runMethods(thesisTargets(), {});
    // TPA and OATPA within what the thesis's 22/7 for pi makes of them.
    EXPECT_NEAR(tableOf(tables, Method::kApa).largest_ha.gon(), 1.47, 0.01);
    EXPECT_NEAR(tableOf(tables, Method::kTpa).largest_ha.gon(), 1.76, 0.02);
    EXPECT_NEAR(tableOf(tables, Method::kOatpa).largest_ha.gon(), 1.71, 0.02);
}

TEST(MethodReportTest, ErrorIsComputedLessObserved) {
    // Object 1: TPA printed 186.7035, sighted 186.1377.
    const auto tables = runMethods(thesisTargets(), {});
    EXPECT_NEAR(tableOf(tables, Method::kTpa).rows[0].error_ha.gon(), 186.7035 - 186.1377, 0.010);
}

TEST(MethodReportTest, FittedRigPointsWithinAFewHundredthsOfAGon) {
    MethodReportOptions options;
    options.fit = fittedRig();
    const auto tables = runMethods(thesisTargets(), options);
    const MethodTable& rigorous = tableOf(tables, Method::kRigorous);
    EXPECT_EQ(rigorous.computed, 11);
    EXPECT_LT(rigorous.rms_ha.gon(), 0.04);
    EXPECT_LT(rigorous.rms_va.gon(), 0.04);
    EXPECT_LT(std::max(rigorous.largest_ha, rigorous.largest_va).gon(), 0.08);
    EXPECT_EQ(tableOf(tables, Method::kRectifiedOatpa).computed, 11);
}

TEST(MethodReportTest, LeaveOneOutTableUsesEachTargetsOwnRig) {
    MethodReportOptions options;
    options.fit = fittedRig();
    options.fit->without.assign(11, options.fit->rig);
    options.fit->without[3].mount.twist = Angle::fromGon(3);
    const auto tables = runMethods(thesisTargets(), options);
    ASSERT_EQ(tables.size(), 6U);
    EXPECT_GT(core::abs(tables.back().rows[3].error_va).gon(), 0.3);
    EXPECT_LT(core::abs(tables.back().rows[2].error_va).gon(), 0.08);
}

TEST(MethodReportTest, RigInUseServesTheRigorousMethodAndTheDistortionTable) {
    MethodReportOptions options;
    options.rig = fittedRig().rig;
    const auto tables = runMethods(thesisTargets(), options);
    EXPECT_EQ(tables.size(), 5U);
    EXPECT_LT(tableOf(tables, Method::kRigorous).rms_ha.gon(), 0.04);
    EXPECT_EQ(tableOf(tables, Method::kRectifiedOatpa).computed, 11);
}

TEST(MethodReportTest, EveryTextIsInTheUnitAskedFor) {
    MethodReportOptions options;
    options.angle_unit = core::AngleUnit::kDegree;
    const QString text = methodReport(thesisTargets(), options);
    EXPECT_TRUE(text.contains("up to 1.32°")) << "1.47 gon";
    EXPECT_TRUE(text.contains("179.4228°")) << "199.3587 gon";
    EXPECT_FALSE(text.contains("gon"));
}

TEST(MethodReportTest, RowsTellTheirDifferenceFromThePrintedColumns) {
    const auto tables = runMethods(thesisTargets(), {});
    const MethodTable& tpa = tableOf(tables, Method::kTpa);
    EXPECT_NEAR(tpa.rows[0].off_printed_ha->gon(), tpa.rows[0].computed->ha.gon() - 186.7035, 1e-9);
    EXPECT_FALSE(tableOf(tables, Method::kRigorous).rows[0].off_printed_ha.has_value());
}

TEST(MethodReportTest, WithoutATableRectifiedOatpaSaysWhatIsMissing) {
    const auto tables = runMethods(thesisTargets(), {});
    const MethodTable& rectified = tableOf(tables, Method::kRectifiedOatpa);
    EXPECT_EQ(rectified.computed, 0);
    EXPECT_THAT(rectified.rows[0].computed, test::FailedWith(core::ErrorKind::kUndefined));
    EXPECT_TRUE(methodReport(thesisTargets(), {}).contains("There is no distortion table."));
}

TEST(MethodReportTest, ListWithoutPrintedColumnsMeasuresItsOwnPixelAngle) {
    auto targets = thesisTargets();
    for (ListedTarget& target : targets) {
        target.printed_apa.reset();
    }
    const auto tables = runMethods(targets, {});
    EXPECT_FALSE(tableOf(tables, Method::kApa).off_printed.has_value());
    // Objects 11 and 5: (225.0055 - 179.1463) / 551 px.
    EXPECT_TRUE(tableOf(tables, Method::kApa).setting.contains("0.08323"));
}

TEST(MethodReportTest, OneTargetHasNoPixelAngleButTheOtherMethodsRun) {
    auto targets = thesisTargets();
    targets.resize(1);
    targets[0].printed_apa.reset();
    const auto tables = runMethods(targets, {});
    EXPECT_EQ(tableOf(tables, Method::kApa).computed, 0);
    EXPECT_EQ(tableOf(tables, Method::kTpa).computed, 1);
}

TEST(MethodReportTest, TextHoldsEveryTableWithRmsMaximumAndPlot) {
    MethodReportOptions options;
    options.fit = fittedRig();
    options.fit->without.assign(11, options.fit->rig);
    const QString text = methodReport(thesisTargets(), options);
    for (const char* part :
         {"table 6.1", "table 6.2", "table 6.3", "table 6.4", "Rigorous: the ray is rotated", "left one out",
          "rms", "maximum", "plot", "Summary", "762.3", "640 x 480", "199.3587"}) {
        EXPECT_TRUE(text.contains(part)) << part;
    }
    EXPECT_FALSE(text.contains("nan"));
}

}  // namespace
}  // namespace pmts::targeting
