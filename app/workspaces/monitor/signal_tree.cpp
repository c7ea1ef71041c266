#include "app/workspaces/monitor/signal_tree.h"

#include "app/workbench/display_quantity.h"
#include "widgets/controls/copy_menu.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/language/whole_numbers.h"
#include "widgets/live_plot/live_plot_spec.h"
#include "widgets/live_plot/stale_text.h"
#include "widgets/theme/theme_style.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMimeData>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <utility>

namespace halbench::app {

namespace {

constexpr int NameRole = Qt::UserRole;

} // namespace

SignalTree::SignalTree(QWidget* parent) : QTreeWidget(parent) {
    setAccessibleName(tr("Signals of the device"));
    setToolTip(tr("Tick to plot a signal (Enter or Space), or drag it onto a plot"));
    setHeaderLabels({tr("Signal"), tr("Now"), tr("Unit")});
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setDragEnabled(true);
    setDragDropMode(QAbstractItemView::DragOnly);
    setUniformRowHeights(true);
    setIndentation(fontMetrics().averageCharWidth() * 2);
    setAlternatingRowColors(false);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    header()->setSectionResizeMode(ValueColumn, QHeaderView::Fixed);
    header()->setSectionResizeMode(UnitColumn, QHeaderView::Fixed);
    setItemDelegate(new widgets::WholeNumbers(this));
    headerItem()->setTextAlignment(ValueColumn, Qt::AlignRight | Qt::AlignVCenter);
    // An identification turns the rotor some hundred times: six digits of degrees.
    const QFontMetrics digits(widgets::tabularFont(font()));
    header()->resizeSection(ValueColumn, digits.horizontalAdvance(QStringLiteral("-000000.00")) +
                                             2 * widgets::PanelMargin_px);
    header()->resizeSection(UnitColumn, std::max(fontMetrics().horizontalAdvance(QStringLiteral("r/min  ")),
                                                 header()->sectionSizeHint(UnitColumn)));
    auto* plot = new QAction(tr("Plot, or remove from the plots"), this);
    connect(plot, &QAction::triggered, this, [this] { toggle(currentItem()); });
    auto* copyName = new QAction(tr("Copy the name for expressions and files"), this);
    connect(copyName, &QAction::triggered, this, [this] {
        if (currentItem() != nullptr) {
            QGuiApplication::clipboard()->setText(currentItem()->data(NameColumn, NameRole).toString());
        }
    });
    addActions({plot, copyName});
    widgets::addCopyMenu(*this);
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        const QString name = item->data(NameColumn, NameRole).toString();
        if (column == NameColumn && !name.isEmpty()) {
            Q_EMIT plotRequested(name, item->checkState(NameColumn) == Qt::Checked);
        }
    });
}

QTreeWidgetItem* SignalTree::groupFor(const QString& title) {
    for (int i = 0; i < topLevelItemCount(); ++i) {
        if (topLevelItem(i)->text(NameColumn) == title) {
            return topLevelItem(i);
        }
    }
    auto* group = new QTreeWidgetItem(this, {title});
    group->setFlags(Qt::ItemIsEnabled);
    group->setExpanded(true);
    group->setFirstColumnSpanned(true);
    return group;
}

void SignalTree::setSignals(const std::vector<SignalSpec>& specs, const DisplayUnits& units) {
    const QSignalBlocker quiet(this);
    clear();
    m_entries.clear();
    const QFont digits = widgets::tabularFont(font());
    for (const SignalSpec& spec : specs) {
        const DisplayQuantity shown = signalQuantity(spec, units);
        QString title = shown.quantity.isEmpty() ? tr("other") : shown.quantity;
        title[0] = title[0].toUpper();
        auto* item = new QTreeWidgetItem(groupFor(title));
        const QString name = QString::fromStdString(spec.name);
        item->setText(NameColumn, signalWords(spec.name));
        item->setData(NameColumn, NameRole, name);
        item->setToolTip(
            NameColumn,
            item->text(NameColumn) + QLatin1Char('\n') + name +
                (spec.help.empty() ? QString() : QLatin1Char('\n') + widgets::inWords(spec.help)));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable |
                       Qt::ItemIsDragEnabled | Qt::ItemNeverHasChildren);
        item->setCheckState(NameColumn, Qt::Unchecked);
        item->setText(UnitColumn, shown.unit);
        item->setTextAlignment(ValueColumn, Qt::AlignRight | Qt::AlignVCenter);
        item->setFont(ValueColumn, digits);
        m_entries[spec.name] = {item, shown.factor, shown.decimals, spec.choices};
    }
    inkUnits();
}

void SignalTree::inkUnits() {
    const QSignalBlocker quiet(this);
    for (const auto& [name, entry] : m_entries) {
        entry.item->setForeground(UnitColumn, widgets::currentTheme().muted);
        inkValue(entry);
    }
}

void SignalTree::changeEvent(QEvent* event) {
    QTreeWidget::changeEvent(event);
    if (event->type() == QEvent::StyleChange) {
        inkUnits();
    }
}

void SignalTree::setPlotted(const std::set<std::string>& names) {
    const QSignalBlocker quiet(this);
    for (const auto& [name, entry] : m_entries) {
        entry.item->setCheckState(NameColumn, names.count(name) > 0 ? Qt::Checked : Qt::Unchecked);
    }
}

QString SignalTree::valueText(const Entry& entry, double value) const {
    const auto choice = static_cast<std::size_t>(std::max(0.0, value));
    if (choice < entry.choices.size() && !entry.choices.empty()) {
        return widgets::inWords(entry.choices[choice]);
    }
    return std::isfinite(value) ? widgets::fixedText(value * entry.factor, entry.decimals)
                                : QStringLiteral("\u2013");
}

void SignalTree::showValues(const control::SampleHistory& history, const QString& stale) {
    const QSignalBlocker quiet(this);
    headerItem()->setText(ValueColumn, stale.isEmpty() ? tr("Now") : tr("Last"));
    for (auto& [name, entry] : m_entries) {
        const auto latest = history.latest(name);
        const QString text = latest ? valueText(entry, latest->value) : QStringLiteral("\u2013");
        if (entry.item->text(ValueColumn) != text) {
            entry.item->setText(ValueColumn, text);
        }
        markStale(entry, widgets::staleWords(history, name, stale));
    }
}

void SignalTree::markStale(Entry& entry, const QString& words) {
    if (std::exchange(entry.stale, words) == words) {
        return;
    }
    QFont digits = widgets::tabularFont(font());
    digits.setItalic(!words.isEmpty());
    entry.item->setFont(ValueColumn, digits);
    entry.item->setToolTip(ValueColumn, words);
    entry.item->setData(ValueColumn, Qt::AccessibleDescriptionRole, words);
    inkValue(entry);
}

void SignalTree::inkValue(const Entry& entry) {
    entry.item->setForeground(ValueColumn,
                              entry.stale.isEmpty() ? QBrush() : QBrush(widgets::currentTheme().muted));
}

void SignalTree::toggle(QTreeWidgetItem* item) {
    if (item != nullptr && (item->flags() & Qt::ItemIsUserCheckable) != 0) {
        const bool isChecked = item->checkState(NameColumn) == Qt::Checked;
        item->setCheckState(NameColumn, isChecked ? Qt::Unchecked : Qt::Checked);
    }
}

void SignalTree::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        toggle(currentItem());
        return;
    }
    QTreeWidget::keyPressEvent(event);
}

QStringList SignalTree::mimeTypes() const {
    return {QLatin1String(widgets::SignalsMimeType)};
}

QMimeData* SignalTree::mimeData(const QList<QTreeWidgetItem*> items) const {
    QStringList names;
    for (const QTreeWidgetItem* item : items) {
        names << item->data(NameColumn, NameRole).toString();
    }
    auto* mime = new QMimeData;
    mime->setData(QLatin1String(widgets::SignalsMimeType), names.join(QLatin1Char('\n')).toUtf8());
    return mime;
}

} // namespace halbench::app
