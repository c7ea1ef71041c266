#pragma once

#include <QtCore/QTemporaryDir>

#include <gtest/gtest.h>

#include <string>

namespace halbench::devices {

/// A folder for the recordings of one test.
class RecordingFolder : public testing::Test {
protected:
    std::string path(const std::string& name) const { return m_folder.filePath(name.c_str()).toStdString(); }

private:
    QTemporaryDir m_folder;
};

} // namespace halbench::devices
