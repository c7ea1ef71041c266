#include "app/window/preferences.h"

#include <QGuiApplication>
#include <QPalette>
#include <QSettings>

#include <algorithm>

namespace halbench::app {

namespace {

constexpr int LongestLockOut_ms = 30000;

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

} // namespace

Preferences loadPreferences() {
    const QSettings settings;
    Preferences preferences;
    preferences.theme = themeChoice(settings.value("theme").toString());
    preferences.language = settings.value("language").toString();
    bool isNumber = false;
    const int lockOut_ms = settings.value("stop_lock_out_ms").toInt(&isNumber);
    if (isNumber) {
        preferences.stopLockOut_ms = std::clamp(lockOut_ms, 0, LongestLockOut_ms);
    }
    preferences.lastDevice = settings.value("last_device").toString();
    preferences.lastProject = settings.value("last_project").toString();
    preferences.geometry = settings.value("geometry").toByteArray();
    preferences.perspective = settings.value("perspective").toString();
    return preferences;
}

void savePreferences(const Preferences& preferences) {
    QSettings settings;
    settings.setValue("theme", word(preferences.theme));
    settings.setValue("language", preferences.language);
    settings.setValue("stop_lock_out_ms", preferences.stopLockOut_ms);
    settings.setValue("last_device", preferences.lastDevice);
    settings.setValue("last_project", preferences.lastProject);
    settings.setValue("geometry", preferences.geometry);
    settings.setValue("perspective", preferences.perspective);
}

QString themeName(ThemeChoice choice) {
    if (choice != ThemeChoice::System) {
        return word(choice);
    }
    const bool isDark = QGuiApplication::palette().color(QPalette::Window).lightnessF() < 0.5;
    return isDark ? "dark" : "light";
}

} // namespace halbench::app
