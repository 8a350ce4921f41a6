#pragma once

#include "pmts/app/desk/workbench.hpp"
#include "pmts/gui/main_window.hpp"

#include <QTemporaryDir>
#include <gmock/gmock.h>

#include <optional>

namespace pmts::test {

/// The whole window over a workbench that was not started: no instrument, no camera, no job.
class WindowFixture : public testing::Test {
protected:
    WindowFixture() {
        app::StartOptions options;
        options.data_folder = folder.path();
        bench.emplace(options);
        window.emplace(*bench);
    }

    QTemporaryDir folder;
    std::optional<app::Workbench> bench;
    std::optional<gui::MainWindow> window;
};

}  // namespace pmts::test
