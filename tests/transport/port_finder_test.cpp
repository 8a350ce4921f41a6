#include "pmts/transport/port_finder.hpp"

namespace pmts::transport {
namespace {

PortInfo adapter(const QString& path, const QString& serial_number) {
    return {.path = path,
            .description = QStringLiteral("FT232R USB UART"),
            .manufacturer = QStringLiteral("FTDI"),
            .serial_number = serial_number,
            .usb_vendor = 0x0403,
            .usb_product = 0x6001};
}

PortInfo plainPort(const QString& path) {
    return {.path = path,
            .description = {},
            .manufacturer = {},
            .serial_number = {},
            .usb_vendor = {},
            .usb_product = {}};
}

const QString kUsb0 = QStringLiteral("/dev/ttyUSB0");
const QString kUsb1 = QStringLiteral("/dev/ttyUSB1");

TEST(PortFinderTest, ReplugedAdapterIsFoundUnderItsNewName) {
    const auto identity = adapter(kUsb0, QStringLiteral("A50285BI")).identity();
    const std::vector present{plainPort(QStringLiteral("/dev/ttyS0")),
                              adapter(kUsb0, QStringLiteral("OTHER")),
                              adapter(kUsb1, QStringLiteral("A50285BI"))};
    EXPECT_EQ(findAgain(identity, present)->path, kUsb1);
}

TEST(PortFinderTest, AnotherAdapterUnderTheOldNameIsNotTaken) {
    const auto identity = adapter(kUsb0, QStringLiteral("A50285BI")).identity();
    EXPECT_FALSE(findAgain(identity, {adapter(kUsb0, QStringLiteral("OTHER"))}).has_value());
    EXPECT_FALSE(findAgain(identity, {plainPort(kUsb0)}).has_value());
}

TEST(PortFinderTest, AdapterWithoutSerialNumberIsFoundWhenItIsTheOnlyOneOfItsKind) {
    const auto identity = adapter(kUsb0, {}).identity();
    EXPECT_EQ(findAgain(identity, {adapter(kUsb1, {})})->path, kUsb1);
}

TEST(PortFinderTest, TwinsWithoutSerialNumberAreToldApartByTheirPlaceOrNotAtAll) {
    const auto identity = adapter(kUsb0, {}).identity();
    EXPECT_EQ(findAgain(identity, {adapter(kUsb1, {}), adapter(kUsb0, {})})->path, kUsb0);
    EXPECT_FALSE(
        findAgain(identity, {adapter(kUsb1, {}), adapter(QStringLiteral("/dev/ttyUSB2"), {})}).has_value());
}

TEST(PortFinderTest, BuiltInPortIsItsName) {
    const auto identity = plainPort(QStringLiteral("/dev/ttyS0")).identity();
    EXPECT_TRUE(findAgain(identity, {plainPort(QStringLiteral("/dev/ttyS0"))}).has_value());
    EXPECT_FALSE(findAgain(identity, {plainPort(QStringLiteral("/dev/ttyS1"))}).has_value());
}

TEST(PortFinderTest, FriendlyNameTellsMakeAndPlace) {
    EXPECT_EQ(adapter(kUsb0, QStringLiteral("A50285BI")).friendlyName(),
              QStringLiteral("FT232R USB UART, FTDI, A50285BI (/dev/ttyUSB0)"));
    EXPECT_EQ(plainPort(QStringLiteral("/dev/ttyS0")).friendlyName(), QStringLiteral("/dev/ttyS0"));
}

TEST(PortFinderTest, PortsOfThisComputerAreListedWithPaths) {
    for (const auto& port : listPorts()) {
        EXPECT_TRUE(port.path.startsWith(u'/') || port.path.startsWith(QStringLiteral("\\\\.\\")));
        EXPECT_EQ(findAgain(port.identity())->path, port.path);
    }
}

}  // namespace
}  // namespace pmts::transport
