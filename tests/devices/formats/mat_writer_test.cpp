#include "devices/formats/mat_writer.h"
#include "mdf4_sample.h"

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>
#include <matio.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>

namespace halbench::devices {
namespace {

StreamLayout named(const std::vector<std::string>& names) {
    StreamLayout layout;
    for (const std::string& name : names) {
        layout.columns.push_back({name, ""});
    }
    return layout;
}

TEST(MatWriter, signalsGetNamesThatTheLanguageTakes) {
    EXPECT_EQ(matNames(named({"hall.a", "2nd", "", "end", "\xC3\xA4", "_x", "a-b"})),
              (std::vector<std::string>{"hall_a", "x_2nd", "x_", "x_end", "x___", "x__x", "a_b"}));
}

TEST(MatWriter, namesThatCollideAreNumbered) {
    EXPECT_EQ(
        matNames(named({"hall.a", "hall_a", "hall-a", "units", "time_s", "hall_a_2"})),
        (std::vector<std::string>{"hall_a", "hall_a_2", "hall_a_3", "units_2", "time_s_2", "hall_a_2_2"}));
}

TEST(MatWriter, namesAreAtMost63CharactersAlsoWithTheirNumber) {
    const std::vector<std::string> names =
        matNames(named({std::string(100, 'a'), std::string(101, 'a'), std::string(100, '1')}));
    EXPECT_NE(names[0], names[1]);
    for (const std::string& name : names) {
        EXPECT_LE(name.size(), 63U);
    }
}

TEST(MatWriter, theLibrarysReaderFindsEveryVariable) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("new/run.mat").toStdString();
    const Mdf4Sample sample = mdf4Sample();
    ASSERT_TRUE(writeMatFile(path, sample.recording, sample.meta));
    EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
    mat_t* file = Mat_Open(path.c_str(), MAT_ACC_RDONLY);
    ASSERT_NE(file, nullptr);
    matvar_t* time = Mat_VarRead(file, "time_s");
    ASSERT_NE(time, nullptr);
    EXPECT_EQ(time->dims[0], sample.recording.rows());
    EXPECT_EQ(static_cast<const double*>(time->data)[19], sample.recording.time_s[19]);
    Mat_VarFree(time);
    for (const char* name : {"position", "x", "x_2", "time", "units", "meta_model", "meta_id", "meta_json"}) {
        matvar_t* variable = Mat_VarReadInfo(file, name);
        EXPECT_NE(variable, nullptr) << name;
        Mat_VarFree(variable);
    }
    Mat_Close(file);
}

TEST(MatWriter, aFullDiskIsNoticedAtEveryOctetAndTheOlderFileStays) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("run.mat").toStdString();
    const Mdf4Sample sample = mdf4Sample();
    ASSERT_TRUE(writeMatFile(path, sample.recording, sample.meta));
    const auto whole = std::filesystem::file_size(path);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    for (rlim_t size = 0; size < whole; ++size) {
        const rlimit small{size, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
        const auto written = writeMatFile(path, sample.recording, sample.meta);
        setrlimit(RLIMIT_FSIZE, &before);
        ASSERT_FALSE(written) << size;
        EXPECT_EQ(written.error().code, ErrorCode::FileSystem);
        EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
    }
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(std::filesystem::file_size(path), whole);
}

TEST(MatWriter, aPlaceThatCannotBeWrittenIsAClearError) {
    const QTemporaryDir folder;
    std::filesystem::create_directory(folder.filePath("run.mat.partial").toStdString());
    const Mdf4Sample sample = mdf4Sample();
    const auto written =
        writeMatFile(folder.filePath("run.mat").toStdString(), sample.recording, sample.meta);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::FileSystem);
    EXPECT_NE(written.error().message.find("run.mat"), std::string::npos);
    EXPECT_FALSE(written.error().hint.empty());
}

} // namespace
} // namespace halbench::devices
