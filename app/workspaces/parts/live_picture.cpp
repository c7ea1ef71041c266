#include "app/workspaces/parts/live_picture.h"

#include "app/workspaces/parts/panel_parts.h"
#include "app/workspaces/parts/signal_box.h"
#include "widgets/controls/empty_state.h"
#include "widgets/figure/figure_view.h"
#include "widgets/language/phrasebook.h"
#include "widgets/theme/icons.h"

#include <QAction>
#include <QLabel>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace halbench::app {

namespace {

constexpr int Period_ms = 250;

} // namespace

LivePicture::LivePicture(Workbench& bench, QWidget* parent) : QWidget(parent), m_bench(bench) {
    m_pages = new QStackedWidget(this);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(m_pages);
}

void LivePicture::begin(const QString& title, const QString& purpose, QWidget* content) {
    auto* empty = new widgets::EmptyState(m_pages);
    empty->setIconName(QStringLiteral("connect"));
    empty->setWords(title, purpose, tr("Connect the simulated motor"), QStringLiteral("Ctrl+Shift+S"));
    m_pages->addWidget(empty);
    m_pages->addWidget(content);
    connect(empty, &widgets::EmptyState::actionTriggered, this, &LivePicture::connectRequested);
    connect(&m_bench, &Workbench::deviceChanged, this, &LivePicture::onDevice);
    connect(&m_bench, &Workbench::displayUnitsChanged, this, &LivePicture::askAnew);
    connect(&m_bench, &Workbench::derivedSignalsChanged, this, &LivePicture::onDerived);
    connect(&m_timer, &QTimer::timeout, this, &LivePicture::ask);
    m_timer.start(Period_ms);
    onDevice();
}

widgets::FigureView* LivePicture::makeView(QWidget* parent, const QString& toolTip, const QString& fileName) {
    auto* view = new widgets::FigureView(parent);
    view->setToolTip(toolTip);
    connect(view, &widgets::FigureView::exportRequested, this,
            [this, view, fileName] { savePictureAs(fileName, view->taken()); });
    return view;
}

void LivePicture::savePictureAs(const QString& fileName, const widgets::PictureSaving& taken) {
    savePicture(this, m_chooser, fileName, m_files, taken, [this](const Error& error) { sayWarning(error); });
}

void LivePicture::addData(const QList<QWidget*>& views, const QString& toolTip, const QString& fileName) {
    auto* save = new QAction(widgets::themedIcon(QStringLiteral("export")), tr("Save data…"), this);
    save->setShortcut(QKeySequence(QStringLiteral("Ctrl+Alt+E")));
    save->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    save->setToolTip(
        QStringLiteral("%1 (%2)").arg(toolTip, save->shortcut().toString(QKeySequence::NativeText)));
    connect(save, &QAction::triggered, this, [this, fileName] { saveData(fileName); });
    addAction(save);
    for (QWidget* view : views) {
        view->addAction(save);
    }
}

/// What is shown now, not after the dialog.
void LivePicture::saveData(const QString& fileName) {
    const Table text = table();
    if (!text) {
        sayWarning({ErrorCode::OutOfRange, "no picture to save", "wait until a picture is shown"});
        return;
    }
    saveText(
        this, m_chooser, {tr("Save data"), fileName, tr("Table (*.csv)")}, m_files,
        [text](const std::string&) -> Result<std::string> { return text(); },
        [this](const QString& path, const Result<void>& written) {
            if (written) {
                m_bench.session().message(MessageLevel::Info, tr("data"), tr("saved: %1").arg(path));
            } else {
                sayWarning(written.error());
            }
        });
}

QLabel* LivePicture::makeWords(QWidget* parent, const QString& accessibleName) {
    m_words = makeNote(parent);
    m_words->setAccessibleName(accessibleName);
    reserveLines(*m_words, 2);
    return m_words;
}

SignalBox* LivePicture::makeBox(QWidget* parent) {
    auto* box = new SignalBox(parent);
    connect(box, &SignalBox::chosen, this, [this] {
        want();
        askAnew();
    });
    m_boxes.push_back(box);
    return box;
}

void LivePicture::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    want();
}

void LivePicture::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    want();
}

void LivePicture::onDevice() {
    const DeviceSession& session = m_bench.session();
    if (session.state() != SessionState::Connected || session.returns() > 0) {
        return; // what was measured can be looked at without the device
    }
    m_pages->setCurrentIndex(1);
    onDerived();
}

void LivePicture::onDerived() {
    if (m_bench.session().state() == SessionState::Connected) {
        takeCatalogue(m_bench.catalogue());
        want();
        askAnew();
    }
}

/// Sent only while somebody looks.
void LivePicture::want() {
    std::vector<std::string> wanted;
    for (const SignalBox* box : m_boxes) {
        if (isVisible() && !box->signal().empty()) {
            wanted.push_back(box->signal());
        }
    }
    m_bench.liveSignals().want(this, std::move(wanted));
}

void LivePicture::askAnew() {
    m_seen.reset();
    m_task.cancel();
    ask();
}

void LivePicture::ask() {
    const std::uint64_t revision = m_bench.history().revision();
    const bool isNew = m_seen != revision && (!isHeld() || !m_seen);
    if (!isVisible() || !isNew || m_task.isBusy() || m_boxes.front()->signal().empty()) {
        return;
    }
    m_seen = revision;
    compute();
}

void LivePicture::sayWarning(const Error& error) {
    m_words->setText(widgets::inWords(error.message) + QStringLiteral(": ") + widgets::inWords(error.hint));
    showRole(*m_words, widgets::Role::Warn);
}

DisplayQuantity LivePicture::shown(const SignalBox& box) const {
    const SignalSpec* spec = m_bench.catalogue().findSignal(box.signal());
    return spec != nullptr ? displayQuantity(spec->unit, m_bench.displayUnits()) : DisplayQuantity{};
}

} // namespace halbench::app
