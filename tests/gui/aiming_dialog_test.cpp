#include "field/aiming_dialog.hpp"

#include "bench_fixture.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

namespace pmts::gui {
namespace {

class AimingDialogTest : public test::WindowFixture {
protected:
    template <class Widget>
    Widget& part(const char* name) {
        return *dialog.findChild<Widget*>(QString::fromLatin1(name));
    }
    void press(QDialogButtonBox::StandardButton button) {
        QTest::mouseClick(part<QDialogButtonBox>("buttons").button(button), Qt::LeftButton);
    }

    AimingDialog dialog{bench->aiming, bench->preferences};
};

TEST_F(AimingDialogTest, EachMethodSaysItsKnownError) {
    auto& method = part<QComboBox>("method");
    ASSERT_EQ(method.count(), 5);
    QStringList errors;
    for (int i = 0; i < method.count(); ++i) {
        method.setCurrentIndex(i);
        errors.append(part<QLabel>("method_error").text());
    }
    EXPECT_EQ(errors.removeDuplicates(), 0);
    EXPECT_TRUE(errors[1].contains(u"1.76 gon")) << "the thesis's largest error of TPA";
}

TEST_F(AimingDialogTest, AppliedMethodIsUsedForTheNextClick) {
    part<QComboBox>("method").setCurrentIndex(1);
    part<QCheckBox>("recentre").setChecked(false);
    press(QDialogButtonBox::Apply);
    EXPECT_EQ(bench->preferences.settings().aiming.method, targeting::Method::kTpa);
    EXPECT_FALSE(bench->preferences.settings().aiming.recentre);
    EXPECT_TRUE(part<QLabel>("answer").text().contains(u"TPA"));
}

TEST_F(AimingDialogTest, WrongLimitIsMarkedWithItsReason) {
    part<QLineEdit>("lowest").setText(QStringLiteral("far down"));
    press(QDialogButtonBox::Apply);
    EXPECT_TRUE(part<QLineEdit>("lowest").property("wrong").toBool());
    EXPECT_FALSE(part<QLabel>("answer").text().isEmpty());
}

TEST_F(AimingDialogTest, FieldsOfWhatIsOffCannotBeTyped) {
    EXPECT_FALSE(part<QLineEdit>("turns").isEnabled());
    part<QCheckBox>("watches_cable").setChecked(true);
    EXPECT_TRUE(part<QLineEdit>("turns").isEnabled());
}

}  // namespace
}  // namespace pmts::gui
