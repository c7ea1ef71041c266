#include "app/window/preferences/preferences.h"

#include <QGuiApplication>
#include <QPalette>
#include <QSettings>

#include <algorithm>
#include <utility>

namespace halbench::app {

namespace {

constexpr const char* ArrangementGroup = "arrangement";
constexpr int RememberedFolders = 50;

ThemeChoice themeChoice(const QString& word) {
    if (word == "light") {
        return ThemeChoice::Light;
    }
    return word == "dark" ? ThemeChoice::Dark : ThemeChoice::System;
}

QString word(ThemeChoice choice) {
    switch (choice) {
    case ThemeChoice::Light:
        return "light";
    case ThemeChoice::Dark:
        return "dark";
    case ThemeChoice::System:
        break;
    }
    return "system";
}

widgets::AngleUnit angleUnit(const QString& word) {
    return word == "rad" ? widgets::AngleUnit::Radian : widgets::AngleUnit::Degree;
}

QString word(widgets::AngleUnit unit) {
    return unit == widgets::AngleUnit::Radian ? "rad" : "deg";
}

constexpr std::pair<SpeedUnit, const char*> SpeedWords[] = {{SpeedUnit::TurnsPerMinute, "r/min"},
                                                            {SpeedUnit::DegreesPerSecond, "deg/s"},
                                                            {SpeedUnit::RadiansPerSecond, "rad/s"}};

SpeedUnit speedUnit(const QString& word) {
    for (const auto& [unit, text] : SpeedWords) {
        if (word == text) {
            return unit;
        }
    }
    return SpeedUnit::TurnsPerMinute;
}

QString word(SpeedUnit wanted) {
    for (const auto& [unit, text] : SpeedWords) {
        if (unit == wanted) {
            return text;
        }
    }
    return {};
}

FrequencyUnit frequencyUnit(const QString& word) {
    return word == "rad/s" ? FrequencyUnit::RadiansPerSecond : FrequencyUnit::Hertz;
}

QString word(FrequencyUnit unit) {
    return unit == FrequencyUnit::RadiansPerSecond ? "rad/s" : "Hz";
}

void loadRecordings(QSettings& settings, Preferences& preferences) {
    const QString mask = settings.value("recording_names").toString();
    if (checkNameMask(mask)) {
        preferences.recordingNames = mask;
    }
    // What is damaged removes nothing.
    bool isNumber = false;
    const int days = settings.value("keep_recordings_days").toInt(&isNumber);
    if (isNumber && days >= 1 && days <= MostRetentionDays) {
        preferences.retention.days = days;
    }
    const int size_GB = settings.value("keep_recordings_gb").toInt(&isNumber);
    if (isNumber && size_GB >= 1 && size_GB <= MostKept_GB) {
        preferences.retention.size_bytes = static_cast<std::uint64_t>(size_GB) * RetentionGB_bytes;
    }
    preferences.retentionFolders = settings.value("keep_recordings_folders").toStringList();
}

void saveLimit(QSettings& settings, const char* key, const std::optional<std::uint64_t>& limit) {
    if (limit) {
        settings.setValue(key, static_cast<qulonglong>(*limit));
    } else {
        settings.remove(key);
    }
}

void saveRecordings(QSettings& settings, const Preferences& preferences) {
    settings.setValue("recording_names", preferences.recordingNames);
    const RetentionLimits& limits = preferences.retention;
    saveLimit(settings, "keep_recordings_days",
              limits.days ? std::optional(static_cast<std::uint64_t>(*limits.days)) : std::nullopt);
    saveLimit(settings, "keep_recordings_gb",
              limits.size_bytes ? std::optional(*limits.size_bytes / RetentionGB_bytes) : std::nullopt);
    settings.setValue("keep_recordings_folders", preferences.retentionFolders);
}

} // namespace

void agreeToRetention(Preferences& preferences, const RetentionLimits& limits, const QString& folder) {
    QStringList& folders = preferences.retentionFolders;
    if (limits != preferences.retention) {
        folders.clear();
    }
    preferences.retention = limits;
    folders.removeAll(folder);
    if (limits.isOn()) {
        folders.prepend(folder);
        folders = folders.mid(0, RememberedFolders);
    }
}

Preferences loadPreferences() {
    QSettings settings;
    Preferences preferences;
    preferences.theme = themeChoice(settings.value("theme").toString());
    preferences.language = settings.value("language").toString();
    bool isNumber = false;
    const int lockOut_ms = settings.value("stop_lock_out_ms").toInt(&isNumber);
    if (isNumber) {
        preferences.stopLockOut_ms = std::clamp(lockOut_ms, 0, LongestLockOut_ms);
    }
    const int history_GB = settings.value("history_limit_gb").toInt(&isNumber);
    if (isNumber) {
        preferences.historyLimit_GB = std::clamp(history_GB, LeastHistory_GB, MostHistory_GB);
    }
    loadRecordings(settings, preferences);
    preferences.units = {angleUnit(settings.value("angle_unit").toString()),
                         speedUnit(settings.value("speed_unit").toString()),
                         frequencyUnit(settings.value("frequency_unit").toString())};
    preferences.geometry = settings.value("geometry").toByteArray();
    preferences.perspective = settings.value("perspective").toString();
    preferences.lastDevice = {settings.value("last_device").toString().toStdString(),
                              settings.value("last_device_serial").toString().toStdString()};
    settings.beginGroup(ArrangementGroup);
    for (const QString& perspective : settings.childKeys()) {
        preferences.arrangements[perspective] = settings.value(perspective).toByteArray();
    }
    return preferences;
}

void savePreferences(const Preferences& preferences) {
    QSettings settings;
    settings.setValue("theme", word(preferences.theme));
    settings.setValue("language", preferences.language);
    settings.setValue("stop_lock_out_ms", preferences.stopLockOut_ms);
    settings.setValue("history_limit_gb", preferences.historyLimit_GB);
    saveRecordings(settings, preferences);
    settings.setValue("angle_unit", word(preferences.units.angle));
    settings.setValue("speed_unit", word(preferences.units.speed));
    settings.setValue("frequency_unit", word(preferences.units.frequency));
    settings.setValue("geometry", preferences.geometry);
    settings.setValue("perspective", preferences.perspective);
    settings.setValue("last_device", QString::fromStdString(preferences.lastDevice.uri));
    settings.setValue("last_device_serial", QString::fromStdString(preferences.lastDevice.serial));
    settings.beginGroup(ArrangementGroup);
    const QHash<QString, QByteArray>& arrangements = preferences.arrangements;
    for (auto entry = arrangements.begin(); entry != arrangements.end(); ++entry) {
        settings.setValue(entry.key(), entry.value());
    }
}

QString themeName(ThemeChoice choice) {
    if (choice != ThemeChoice::System) {
        return word(choice);
    }
    const bool isDark = QGuiApplication::palette().color(QPalette::Window).lightnessF() < 0.5;
    return isDark ? "dark" : "light";
}

} // namespace halbench::app
