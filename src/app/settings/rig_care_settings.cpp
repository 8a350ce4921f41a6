#include "pmts/app/settings/rig_care_settings.hpp"

#include "setting_values.hpp"

namespace pmts::app {

void RigCareSettings::load(const QSettings& file) {
    age_limit_days = static_cast<int>(numberFrom(file, "rig_care/age_limit_days", age_limit_days, 1, 3650));
    temperature_limit_c = numberFrom(file, "rig_care/temperature_limit_c", temperature_limit_c, 1, 100);
    check_limit_px = numberFrom(file, "rig_care/check_limit_px", check_limit_px, 0.05, 100);
    check_limit = core::Angle::fromGon(numberFrom(file, "rig_care/check_limit_gon", check_limit.gon(), 1e-4, 10));
    knock_limit_px = numberFrom(file, "rig_care/knock_limit_px", knock_limit_px, 0.5, 500);
    knock_moves = static_cast<int>(numberFrom(file, "rig_care/knock_moves", knock_moves, 3, 50));
    calibration::BoardPattern read{.columns = static_cast<int>(numberFrom(file, "rig_care/board_columns", board.columns, 3, 60)),
                                   .rows = static_cast<int>(numberFrom(file, "rig_care/board_rows", board.rows, 3, 60)),
                                   .square_m = numberFrom(file, "rig_care/board_square_m", board.square_m, 0.001, 1.0),
                                   .dictionary = file.value(QStringLiteral("rig_care/board_dictionary")).toString()};
    if (calibration::usablePattern(read)) {
        board = read;
    }
}

void RigCareSettings::save(QSettings& file) const {
    file.setValue(QStringLiteral("rig_care/age_limit_days"), age_limit_days);
    file.setValue(QStringLiteral("rig_care/temperature_limit_c"), temperature_limit_c);
    file.setValue(QStringLiteral("rig_care/check_limit_px"), check_limit_px);
    file.setValue(QStringLiteral("rig_care/check_limit_gon"), check_limit.gon());
    file.setValue(QStringLiteral("rig_care/knock_limit_px"), knock_limit_px);
    file.setValue(QStringLiteral("rig_care/knock_moves"), knock_moves);
    file.setValue(QStringLiteral("rig_care/board_columns"), board.columns);
    file.setValue(QStringLiteral("rig_care/board_rows"), board.rows);
    file.setValue(QStringLiteral("rig_care/board_square_m"), board.square_m);
    file.setValue(QStringLiteral("rig_care/board_dictionary"), board.dictionary);
}

}  // namespace pmts::app
