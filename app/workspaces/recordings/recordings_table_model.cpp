#include "app/workspaces/recordings/recordings_table_model.h"

#include "widgets/controls/progress_row.h"
#include "widgets/language/display_units.h"
#include "widgets/language/local_time.h"

#include <QLocale>

#include <utility>

namespace halbench::app {

namespace {

QString number(std::uint64_t value) {
    return widgets::countText(value);
}

QString gapsText(const RecordingEntry& entry) {
    if (entry.isInterrupted) {
        return RecordingsTableModel::tr("interrupted");
    }
    return entry.gaps == 0
               ? QString()
               : RecordingsTableModel::tr("%1 (%2 rows)").arg(number(entry.gaps), number(entry.missingRows));
}

/// The simulated ones' own identities begin with "sim".
QString deviceText(const RecordingEntry& entry) {
    const bool isSaid = entry.device.startsWith(QLatin1String("sim"));
    return entry.isSimulated && !isSaid ? RecordingsTableModel::tr("%1 (simulated)").arg(entry.device)
                                        : entry.device;
}

QString text(const RecordingEntry& entry, int column) {
    switch (column) {
    case RecordingsTableModel::Name:
        return entry.name;
    case RecordingsTableModel::Date:
        return widgets::localTimeText(entry.date);
    case RecordingsTableModel::Length:
        return entry.duration_s ? widgets::durationText(*entry.duration_s) : QString();
    case RecordingsTableModel::Device:
        return deviceText(entry);
    case RecordingsTableModel::Signals:
        return entry.signalNames.isEmpty() ? QString() : number(entry.signalNames.size());
    case RecordingsTableModel::Gaps:
        return gapsText(entry);
    case RecordingsTableModel::Tags:
        return entry.tags.join(QLatin1String(", "));
    default:
        return entry.results.join(QLatin1String(", "));
    }
}

QVariant sortKey(const RecordingEntry& entry, int column) {
    switch (column) {
    case RecordingsTableModel::Date:
        return entry.date;
    case RecordingsTableModel::Length:
        return entry.duration_s.value_or(-1.0);
    case RecordingsTableModel::Signals:
        return entry.signalNames.size();
    case RecordingsTableModel::Gaps:
        return entry.isInterrupted ? -1 : static_cast<qlonglong>(entry.missingRows);
    default:
        return text(entry, column).toLower();
    }
}

QString toolTip(const RecordingEntry& entry, int column) {
    if (column == RecordingsTableModel::Signals) {
        return entry.signalNames.join(QLatin1Char('\n'));
    }
    if (column == RecordingsTableModel::Results) {
        return entry.results.join(QLatin1Char('\n'));
    }
    return entry.notes.isEmpty() ? entry.path : entry.path + QLatin1Char('\n') + entry.notes;
}

} // namespace

void RecordingsTableModel::setEntries(std::vector<RecordingEntry> entries) {
    if (entries == m_entries) {
        return; // the selection stays
    }
    beginResetModel();
    m_entries = std::move(entries);
    endResetModel();
}

void RecordingsTableModel::setWords(const QString& path, const QStringList& tags, const QString& notes) {
    const int row = rowOf(path);
    if (row >= 0) {
        m_entries[static_cast<std::size_t>(row)].tags = tags;
        m_entries[static_cast<std::size_t>(row)].notes = notes;
        Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
    }
}

int RecordingsTableModel::rowOf(const QString& path) const {
    for (std::size_t row = 0; row < m_entries.size(); ++row) {
        if (m_entries[row].path == path) {
            return static_cast<int>(row);
        }
    }
    return -1;
}

int RecordingsTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_entries.size());
}

int RecordingsTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant RecordingsTableModel::data(const QModelIndex& index, int role) const {
    const RecordingEntry& one = entry(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return text(one, index.column());
    case Qt::ToolTipRole:
        return toolTip(one, index.column());
    case Qt::TextAlignmentRole:
        return index.column() == Length || index.column() == Signals
                   ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                   : QVariant();
    case SortRole:
        return sortKey(one, index.column());
    case SearchRole:
        return searchText(one);
    default:
        return {};
    }
}

QVariant RecordingsTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    const QString titles[ColumnCount] = {tr("Name"),    tr("Date"), tr("Length"), tr("Device"),
                                         tr("Signals"), tr("Gaps"), tr("Tags"),   tr("Results")};
    return titles[section];
}

void RecordingsFilterModel::setWords(const QString& words) {
    m_words = words.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
}

bool RecordingsFilterModel::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QString text =
        sourceModel()->index(row, 0, parent).data(RecordingsTableModel::SearchRole).toString();
    return hasWords(text, m_words);
}

} // namespace halbench::app
