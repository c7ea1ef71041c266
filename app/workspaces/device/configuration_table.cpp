#include "app/workspaces/device/configuration_table.h"

#include "widgets/controls/copy_menu.h"
#include "widgets/language/display_units.h"
#include "widgets/language/phrasebook.h"
#include "widgets/language/whole_numbers.h"

#include <QHeaderView>
#include <QSignalBlocker>

#include <algorithm>

namespace halbench::app {

namespace {

/// As many digits as a 32-bit number has.
QString numberWords(const std::optional<double>& value) {
    return value ? widgets::numberText(*value, 7) : QStringLiteral("–");
}

} // namespace

ConfigurationTable::ConfigurationTable(QWidget* parent) : QTreeWidget(parent) {
    setAccessibleName(tr("Rows of the configuration"));
    setToolTip(tr("Ticked rows are restored (Space). Values in SI units, as in the file"));
    setHeaderLabels({tr("Parameter"), tr("Device"), tr("File"), tr("State"), tr("Default"), tr("Unit")});
    setRootIsDecorated(false);
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    for (const int column : {DeviceColumn, FileColumn, DefaultColumn}) {
        headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    header()->setStretchLastSection(true);
    setItemDelegate(new widgets::WholeNumbers(this));
    widgets::addCopyMenu(*this);
    connect(this, &QTreeWidget::itemChanged, this, &ConfigurationTable::ticksChanged);
    connect(this, &QTreeWidget::currentItemChanged, this, &ConfigurationTable::tellReason);
}

void ConfigurationTable::show(const ConfigurationComparison& comparison, bool keepTicks) {
    const std::vector<std::string> before = ticked();
    const std::vector<ComparedRow> rowsBefore = m_rows;
    const auto isOver = [&](const RowOutcome& outcome) {
        return !keepTicks ||
               std::any_of(comparison.rows.begin(), comparison.rows.end(), [&](const auto& row) {
                   return row.name == outcome.name && outcome.isRestored && row.state == RowState::Differs;
               });
    };
    m_outcomes.erase(std::remove_if(m_outcomes.begin(), m_outcomes.end(), isOver), m_outcomes.end());
    {
        const QSignalBlocker quiet(this);
        clear();
        m_rows = comparison.rows;
        for (const ComparedRow& row : m_rows) {
            const bool wasThere = std::any_of(rowsBefore.begin(), rowsBefore.end(), [&](const auto& old) {
                return old.name == row.name && old.state == RowState::Differs;
            });
            const bool wasTicked = std::find(before.begin(), before.end(), row.name) != before.end();
            addTopLevelItem(makeRow(row, keepTicks && wasThere ? wasTicked : row.isProposed));
        }
        hideRows();
    }
    tellReason();
    Q_EMIT ticksChanged();
}

QTreeWidgetItem* ConfigurationTable::makeRow(const ComparedRow& row, bool isTicked) {
    auto* item = new QTreeWidgetItem({QString::fromStdString(row.name), numberWords(row.device),
                                      numberWords(row.file), stateWords(row), numberWords(row.defaultValue),
                                      QString::fromStdString(row.unit)});
    for (const int column : {DeviceColumn, FileColumn, DefaultColumn}) {
        item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    }
    item->setToolTip(StateColumn, reasonWords(row));
    if (row.state == RowState::Differs) {
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(NameColumn, isTicked ? Qt::Checked : Qt::Unchecked);
    } else {
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    }
    return item;
}

const RowOutcome* ConfigurationTable::outcomeOf(const std::string& name) const {
    const auto outcome = std::find_if(m_outcomes.begin(), m_outcomes.end(),
                                      [&](const RowOutcome& each) { return each.name == name; });
    return outcome == m_outcomes.end() ? nullptr : &*outcome;
}

QString ConfigurationTable::stateWords(const ComparedRow& row) const {
    if (const RowOutcome* outcome = outcomeOf(row.name)) {
        return outcome->isRestored ? tr("restored") : tr("not restored");
    }
    switch (row.state) {
    case RowState::Same:
        return tr("the same");
    case RowState::Differs:
        return row.isCalibration ? tr("calibration") : tr("differs");
    case RowState::OnlyOnDevice:
        return tr("not in the file");
    case RowState::OnlyInFile:
    case RowState::Refused:
        break;
    }
    return tr("refused");
}

QString ConfigurationTable::reasonWords(const ComparedRow& row) const {
    const RowOutcome* outcome = outcomeOf(row.name);
    if (outcome == nullptr && row.isCalibration && row.state == RowState::Differs) {
        return tr("differs; calibration value, valid for one device only");
    }
    return widgets::inWords(outcome != nullptr ? outcome->reason : row.reason);
}

void ConfigurationTable::tellReason() {
    const int current = indexOfTopLevelItem(currentItem());
    Q_EMIT reasonChanged(current < 0 ? QString() : reasonWords(m_rows[static_cast<std::size_t>(current)]));
}

void ConfigurationTable::showOutcomes(const std::vector<RowOutcome>& outcomes) {
    m_outcomes = outcomes;
    const QSignalBlocker quiet(this);
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        QTreeWidgetItem* item = topLevelItem(static_cast<int>(i));
        item->setText(StateColumn, stateWords(m_rows[i]));
        item->setToolTip(StateColumn, reasonWords(m_rows[i]));
    }
    hideRows();
    tellReason();
}

void ConfigurationTable::setDifferencesOnly(bool isOnly) {
    m_isDifferencesOnly = isOnly;
    hideRows();
}

/// What was restored stays in sight although it is the same by now.
void ConfigurationTable::hideRows() {
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const ComparedRow& row = m_rows[i];
        const bool isDull = row.state == RowState::Same || row.state == RowState::OnlyOnDevice;
        const bool hasOutcome = outcomeOf(row.name) != nullptr;
        topLevelItem(static_cast<int>(i))->setHidden(m_isDifferencesOnly && isDull && !hasOutcome);
    }
}

std::vector<std::string> ConfigurationTable::ticked() const {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (topLevelItem(static_cast<int>(i))->checkState(NameColumn) == Qt::Checked) {
            names.push_back(m_rows[i].name);
        }
    }
    return names;
}

void ConfigurationTable::tickCalibration(bool isTicked) {
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i].isCalibration && m_rows[i].state == RowState::Differs) {
            topLevelItem(static_cast<int>(i))
                ->setCheckState(NameColumn, isTicked ? Qt::Checked : Qt::Unchecked);
        }
    }
}

} // namespace halbench::app
