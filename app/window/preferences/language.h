#pragma once

#include <QLocale>
#include <QString>
#include <QStringList>

#include <vector>

class QCoreApplication;

namespace halbench::app {

struct Language {
    QString id;   ///< "en", "de", "zh_CN": as in the preferences and in translations/halbench_<id>.ts
    QString name; ///< in the language itself, so that its speakers find it
};

const std::vector<Language>& languages();

/// The wish when the program speaks it, else the first language of the system that it speaks, else English.
QString chosenLanguage(const QString& wish, const QStringList& systemLanguages);

/// Numbers and dates: as the system writes them when it speaks this language, else as the language does.
QLocale localeOf(const QString& language, const QLocale& system);

/// From now on the program's and Qt's own words are in this language, and the default locale fits it. Call it
/// once, before the first widget: what was made before keeps its words.
void speak(QCoreApplication& application, const QString& language);

/// The language that speak() chose; English where nobody did.
QString spokenLanguage();

} // namespace halbench::app
