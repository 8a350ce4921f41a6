#pragma once

#include "bench_fixture.hpp"

namespace pmts::test {

/// The whole window, asked for the panels of the laboratory's steps and for what stands on them.
class LabFixture : public WindowFixture {
protected:
    template <class Step>
    [[nodiscard]] Step* step() const {
        auto* const found = window->findChild<Step*>();
        EXPECT_NE(found, nullptr);
        return found;
    }
    template <class Widget>
    [[nodiscard]] static Widget* child(const QWidget* panel, const char* name) {
        auto* const found = panel->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
};

}  // namespace pmts::test
