#include "devices/formats/recording_file.h"
#include "tests/conformance/ports/served_motor.h"

#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>

namespace halbench::devices {
namespace {

/// What the built program did: nothing of it is linked into this test, it meets the mock machine through the
/// system's libraries as it would meet a real one.
struct Ended {
    int exitCode = -1;
    std::string output;
};

Ended run(const std::string& arguments) {
    Ended result;
    const std::string command = fmt::format("'{}' {}", HALBENCH_PROGRAM, arguments);
    FILE* pipe = ::popen(command.c_str(), "r");
    std::array<char, 4096> text{};
    while (std::fgets(text.data(), static_cast<int>(text.size()), pipe) != nullptr) {
        result.output += text.data();
    }
    const int status = ::pclose(pipe);
    result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return result;
}

QJsonObject listed(const std::string& json, const QString& uri) {
    const auto document = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
    for (const QJsonValue& device : document["devices"].toArray()) {
        if (device.toObject()["uri"].toString() == uri) {
            return device.toObject();
        }
    }
    return {};
}

/// Half a second at 100 Hz, through `record`: rows with even time, nothing lost.
void recordsFrom(const std::string& uri) {
    const QTemporaryDir folder;
    const std::string file = folder.filePath("run.csv").toStdString();
    const Ended recorded =
        run(fmt::format("record {} --signals position,speed --rate 100 --duration 0.5 --out {}", uri, file));
    ASSERT_EQ(recorded.exitCode, 0) << recorded.output;
    const auto read = readRecordingFile(file);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_GE(read->recording.rows(), 49U);
    EXPECT_EQ(read->recording.lostRows, 0U);
}

TEST(Program, listsWhatIsPluggedInAndNothingElse) {
    const MockMachine machine;
    EXPECT_TRUE(listed(run("devices --json").output, "usb:1209:0001:HB-17").isEmpty());
    MockBulkBoard bulk(machine, 4, "HB-17");
    MockHidBoard hid(machine, 3, "HB-9");
    const Ended devices = run("devices --json");
    ASSERT_EQ(devices.exitCode, 0);
    const QJsonObject usb = listed(devices.output, "usb:1209:0001:HB-17");
    EXPECT_EQ(usb["name"].toString(), "Halbench Test board") << devices.output;
    EXPECT_TRUE(usb["available"].toBool());
    EXPECT_EQ(usb["id"].toString(), "HB-17");
    EXPECT_EQ(listed(devices.output, "hid:1209:0001:HB-9")["name"].toString(), "Halbench HID board");
}

TEST(Program, recordsAndSetsOverBulkEndpoints) {
    const MockMachine machine;
    MockBulkBoard mock(machine, 4, "HB-17");
    const ServedMotor motor(mock);
    recordsFrom("usb:1209:0001:HB-17");
    const Ended set = run("set usb:1209:0001:HB-17 gain.kp=12.5");
    EXPECT_EQ(set.exitCode, 0) << set.output;
    EXPECT_EQ(run("get usb:1209:0001:HB-17 gain.kp").output, "gain.kp = 12.5 A/rad\n");
}

TEST(Program, recordsOverHidReports) {
    const MockMachine machine;
    MockHidBoard mock(machine, 3, "HB-9");
    const ServedMotor motor(mock);
    recordsFrom("hid:1209:0001");
}

TEST(Program, aPortThatIsNotThereExitsAsADeviceFailure) {
    const MockMachine machine;
    MockBulkBoard mock(machine, 4, "HB-17");
    const Ended wrong = run("describe usb:1209:0001:HB-18 --json");
    EXPECT_EQ(wrong.exitCode, 3);
    EXPECT_NE(wrong.output.find("HB-17"), std::string::npos) << wrong.output;
}

} // namespace
} // namespace halbench::devices
