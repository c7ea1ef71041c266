#include "tests/gui/screenshots/photographer.h"

#include "app/procedures/move/move_procedure.h"
#include "app/window/docks/dock_layout.h"
#include "app/window/help/help_window.h"
#include "app/workspaces/recordings/import_view.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QPixmap>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <qtadvanceddocking/DockWidget.h>

#include <algorithm>
#include <utility>

namespace halbench::app {

Photographer::Photographer(QString folder, QString language, QSize size)
    : m_folder(std::move(folder)), m_language(std::move(language)), m_window(dressed(m_language)) {
    m_window.resize(size);
    m_window.show();
}

bool Photographer::takeHelp() {
    const std::pair<const char*, const char*> pages[] = {
        {"help-index", "index.md"},         {"help-monitor", "monitor.md"},
        {"help-drive", "monitor.md#drive"}, {"help-field", "monitor.md#field"},
        {"help-tune", "tuning.md#margins"}, {"help-english", "protocol.md"}};
    for (const auto& [scene, address] : pages) {
        HelpWindow help(address, &m_window);
        help.show();
        take(QString::fromLatin1(scene), help);
    }
    return m_isSaved;
}

bool Photographer::takeRecordings() {
    const QDir recordings(QDir(m_folder).filePath(QStringLiteral("recordings")));
    if (recordings.entryList({QStringLiteral("*.csv"), QStringLiteral("*.mf4")}).isEmpty()) {
        qWarning("there are no recordings in %s", qPrintable(recordings.path()));
        return false;
    }
    m_window.bench().recording().setFolder(recordings.path());
    m_window.docks().setPerspective(Perspective::Record);
    QTest::qWait(Settling_ms);
    QWidget* panel = m_window.docks().panel("recordings");
    const QList<QTableView*> tables = panel->findChildren<QTableView*>(); // others are of items
    QTableView* table = *std::find_if(tables.begin(), tables.end(), [](const QTableView* one) {
        return qobject_cast<const QTableWidget*>(one) == nullptr;
    });
    if (!wait([table] { return table->model()->rowCount() > 0; })) {
        return false;
    }
    table->selectAll();
    QTest::qWait(DataTime_ms / 5);
    take(QStringLiteral("recordings-overlay"));
    auto* tabs = panel->findChild<QTabWidget*>();
    tabs->setCurrentIndex(1);
    take(QStringLiteral("recordings-results"));
    tabs->setCurrentIndex(3);
    const QString import = QDir(m_folder).filePath(QStringLiteral("recordings/import.txt"));
    if (QFile::exists(import)) { // a table of another program, if there is one
        panel->findChild<ImportView*>()->begin(import);
        QTest::qWait(DataTime_ms / 5);
    }
    take(QStringLiteral("recordings-import"));
    tabs->setCurrentIndex(0);
    table->selectRow(0);
    press("recordings", "halbench::app::RecordingsPanel", "Replay");
    QTest::qWait(DataTime_ms / 2);
    take(QStringLiteral("recordings-played"));
    return m_isSaved;
}

bool Photographer::takeAll() {
    takePerspectives(QStringLiteral("empty-"));
    m_window.connectDevice(QStringLiteral("sim:htm"));
    if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
        return false;
    }
    startMotion("sine,amplitude_deg=100,period_s=2");
    m_window.docks().setPerspective(Perspective::Monitor);
    front("monitor");
    QTest::qWait(DataTime_ms);
    takePerspectives({});
    return endMotion() && takeCalibration() && takeIdentification() && takeTuning() && m_isSaved;
}

bool Photographer::takeDevice(const QString& uri) {
    m_window.connectDevice(uri);
    if (!wait([this] { return !m_window.bench().deviceValues().empty(); })) {
        return false;
    }
    front("monitor");
    for (const Perspective perspective : {Perspective::Monitor, Perspective::Field}) {
        m_window.docks().setPerspective(perspective);
        QTest::qWait(DataTime_ms);
        take(QStringLiteral("device-") + perspectiveId(perspective));
    }
    return m_isSaved;
}

Preferences Photographer::dressed(const QString& language) {
    wear(ThemeChoice::Light);
    Preferences preferences;
    preferences.theme = ThemeChoice::Light;
    preferences.language = language;
    return preferences;
}

void Photographer::wear(ThemeChoice choice) {
    if (const Result<widgets::Theme> theme = widgets::loadTheme(themeName(choice).toStdString())) {
        widgets::applyTheme(*qApp, *theme, {QLocale(), widgets::Dress().fontSize_pt});
    }
}

void Photographer::front(const char* panel) {
    for (ads::CDockWidget* dock : m_window.docks().docks()) {
        if (dock->objectName() == QLatin1String(panel)) {
            dock->setAsCurrentTab();
        }
    }
}

void Photographer::takePanel(const char* panel, const char* scene) {
    front(panel);
    QTest::qWait(DataTime_ms);
    take(QStringLiteral("monitor-") + QLatin1String(scene));
}

bool Photographer::endMotion() {
    session().abortProcedure();
    if (!wait([this] { return session().procedure().isEmpty(); })) {
        return false;
    }
    session().request([](devices::Device& device) { return device.clearStop(); }, [](Result<void>) {});
    return true;
}

void Photographer::trigger(const QWidget& panel, const char* key) {
    for (QAction* action : panel.actions()) {
        if (action->shortcut() == QKeySequence(QLatin1String(key))) {
            action->trigger();
        }
    }
}

void Photographer::startMotion(const char* reference) {
    session().runProcedure(
        QCoreApplication::translate("Panels", "Drive"),
        [reference](devices::Device& device, const ProcedureObserver& observer) {
            MoveConfig config;
            config.reference = *parseMoveReference(reference);
            config.duration_s = 60.0;
            return runMove(device, config, observer);
        },
        [](Result<MoveResult>) {});
}

void Photographer::take(const QString& scene, QWidget& shown) {
    for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
        wear(choice);
        QTest::qWait(Settling_ms);
        const QString file = QStringLiteral("%1-%2-%3-%4x.png")
                                 .arg(scene, themeName(choice), m_language)
                                 .arg(shown.devicePixelRatioF());
        m_isSaved = shown.grab().save(QDir(m_folder).filePath(file)) && m_isSaved;
    }
}

void Photographer::takePerspectives(const QString& prefix) {
    for (const Perspective perspective : AllPerspectives) {
        m_window.docks().setPerspective(perspective);
        take(prefix + perspectiveId(perspective));
    }
}

bool Photographer::press(const char* panel, const char* context, const char* text) {
    QTest::qWait(Settling_ms);
    const QString words = QCoreApplication::translate(context, text);
    for (auto* button : m_window.docks().panel(panel)->findChildren<QAbstractButton*>()) {
        if (button->text() == words && wait([&] { return button->isEnabled(); })) {
            button->click();
            return true;
        }
    }
    return false;
}

} // namespace halbench::app
