#include "app/window/preferences/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QTranslator>

#include <algorithm>

// The macro declares a function of the global namespace.
static void registerTranslations() {
    Q_INIT_RESOURCE(translations);
}

namespace halbench::app {

namespace {

bool isSpoken(const QString& id) {
    return std::any_of(languages().begin(), languages().end(),
                       [&](const Language& one) { return one.id == id; });
}

void install(QCoreApplication& application, const QString& file, const QString& folder) {
    auto* translator = new QTranslator(&application);
    if (translator->load(file, folder)) { // what is not installed leaves Qt's own words in English
        QCoreApplication::installTranslator(translator);
    } else {
        delete translator;
    }
}

} // namespace

const std::vector<Language>& languages() {
    static const std::vector<Language> all = {{QStringLiteral("en"), QStringLiteral("English")},
                                              {QStringLiteral("de"), QStringLiteral("Deutsch")},
                                              {QStringLiteral("zh_CN"), QStringLiteral("简体中文")}};
    return all;
}

QString chosenLanguage(const QString& wish, const QStringList& systemLanguages) {
    if (isSpoken(wish)) {
        return wish;
    }
    for (const QString& tag : systemLanguages) {
        const QLocale one(tag);
        for (const QString& id : {one.name(), one.name().section(QLatin1Char('_'), 0, 0)}) {
            if (isSpoken(id)) {
                return id;
            }
        }
    }
    return QStringLiteral("en");
}

QLocale localeOf(const QString& language, const QLocale& system) {
    const QLocale own(language);
    return system.language() == own.language() && system.script() == own.script() ? system : own;
}

void speak(QCoreApplication& application, const QString& language) {
    registerTranslations();
    install(application, QStringLiteral("qtbase_") + language,
            QLibraryInfo::location(QLibraryInfo::TranslationsPath));
    install(application, QStringLiteral("halbench_") + language, QStringLiteral(":/translations"));
    QLocale::setDefault(localeOf(language, QLocale::system()));
}

QString spokenLanguage() {
    const QLocale now;
    const auto found = std::find_if(languages().begin(), languages().end(), [&](const Language& one) {
        const QLocale own(one.id);
        return own.language() == now.language() && own.script() == now.script();
    });
    return found == languages().end() ? QStringLiteral("en") : found->id;
}

} // namespace halbench::app
