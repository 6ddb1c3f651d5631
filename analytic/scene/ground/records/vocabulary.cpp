#include "analytic/scene/ground/records/vocabulary.hpp"

#include <algorithm>
#include <span>

#include "analytic/scene/ground/records/text.hpp"

namespace rockstack::records {
namespace {

using Vocabulary = std::span<const std::string_view>;

constexpr std::string_view acceleration_words[] = {
    "accx",          "accy",         "accz",           "accelx",        "accely",
    "accelz",        "acc",          "accs",           "accn",          "accel",
    "accels",        "accelerogram", "accelerogramme", "beschl",        "aceleracion",
    "aceleraciones", "aceleracao",   "accelerazione",  "accelerazioni", "ivme",
    "ivmesi",        "επιταχυνση",   "επιταχυνσεις",   "ускорение",     "ускорения",
    "加速度",        "gforce"};
constexpr std::string_view acceleration_letters[] = {"a", "ax", "ay", "az", "ag"};
constexpr std::string_view acceleration_parts[] = {"acceleration", "beschleunigung"};
constexpr std::string_view velocity_words[] = {"velocity", "velocities", "vel",      "veloc",      "vitesse",
                                               "vitesses", "velocidad",  "velocita", "velocidade", "hiz",
                                               "hizi",     "ταχυτητα",   "скорость", "速度"};
constexpr std::string_view velocity_parts[] = {"geschwindigkeit"};
constexpr std::string_view displacement_words[] = {
    "displacement", "displacements", "disp",        "dis",           "displ",     "displac",
    "weg",          "auslenkung",    "deplacement", "deplacements",  "deplasman", "desplazamiento",
    "deslocamento", "spostamento",   "spostamenti", "yerdegistirme", "otelenme",  "μετατοπιση",
    "μετακινηση",   "перемещение",   "смещение",    "変位",          "position",  "positions",
    "posizione",    "posicion",      "distance",    "distances",     "dist",      "abstand",
    "entfernung",   "distanza",      "distancia",   "mesafe",        "konum",     "αποσταση",
    "расстояние"};
constexpr std::string_view displacement_parts[] = {"verschiebung"};
constexpr std::string_view full_times[] = {
    "time",      "times",      "zeit",    "zeiten",   "temps",    "tiempo",   "tempo",  "elapsed",
    "timestamp", "timestamps", "zaman",   "sure",     "χρονοσ",   "время",    "時間",   "时间",
    "millis",    "micros",     "seconds", "sekunden", "secondes", "segundos", "secondi"};
constexpr std::string_view full_time_parts[] = {"zeitpunkt", "zeitachse", "laufzeit", "messzeit"};
constexpr std::string_view time_letters[] = {"t"};
constexpr std::string_view second_words[] = {"sn",       "saniye",  "δευτ",    "δευτ.",    "δευτερολεπτα",
                                             "с",        "сек",     "секунды", "秒",       "segundo",
                                             "segundos", "secondo", "secondi", "sekunden", "secondes"};
constexpr std::string_view angle_words[] = {
    "angle",  "angles", "theta",   "θ",    "phi",         "φ",           "tilt", "angolo",
    "angoli", "angulo", "angulos", "aci",  "acisi",       "γωνια",       "угол", "neigung",
    "pitch",  "roll",   "yaw",     "角度", "inclination", "inclinazione"};
constexpr std::string_view angle_parts[] = {"winkel"};
constexpr std::string_view rotation_words[] = {
    "rot",  "rota",      "rotx", "roty",  "rotz", "angular", "angulaire", "angolare",
    "gyro", "gyroscope", "gyr",  "omega", "ω",    "acisal",  "γωνιακη",   "угловое"};
constexpr std::string_view rotation_parts[] = {"rotation",   "rotazion",     "rotacion",
                                               "drehung",    "drehrate",     "drehbeschl",
                                               "drehgeschw", "winkelbeschl", "winkelgeschw"};
constexpr std::string_view other_words[] = {
    // Forces, moments, stresses, energies.
    "force", "forces", "load", "loads", "moment", "torque", "kraft", "krafte", "last", "lasten", "forza",
    "forze", "carico", "fuerza", "carga", "charge", "kuvvet", "kuvveti", "yuk", "δυναμη", "φορτιο", "сила",
    "нагрузка", "stress", "spannung", "spannungen", "tensione", "esfuerzo", "contrainte", "gerilme", "energy",
    "energie", "energia", "power", "leistung", "work", "impulse", "shear",
    // Quantities of recorders.
    "voltage", "voltages", "volt", "volts", "tension", "voltaje", "voltaggio", "gerilim", "ταση",
    "напряжение", "current", "strom", "courant", "corriente", "battery", "status", "flag", "temp",
    "temperature", "temperatures", "temperatur", "temperatura", "sicaklik", "θερμοκρασια", "температура",
    "humidity", "light", "magnetic", "magnetometer", "mag",
    // Quantities of bodies and places.
    "mass", "masses", "masse", "massen", "massa", "masa", "kutle", "μαζα", "масса", "weight", "gewicht",
    "peso", "poids", "pressure", "pressures", "druck", "pression", "pressione", "presion", "basinc", "πιεση",
    "давление", "strain", "strains", "dehnung", "deformation", "deformazione", "deformacion",
    "sekildegistirme", "drift", "density", "dichte", "volume", "depth", "depths", "tiefe", "profondeur",
    "profondita", "profundidad", "derinlik", "βαθοσ", "глубина", "height", "hohe", "hauteur", "altezza",
    "altura", "yukseklik", "elevation", "altitude", "latitude", "longitude", "lat", "lon", "floor", "floors",
    "storey", "story", "etage", "stockwerk", "piano", "piso", "magnitude", "magnitudes",
    // Measures of a record, and of others.
    "pga", "pgv", "pgd", "rpm", "bpm", "arias", "husid", "intensity", "duration", "cav", "jerk", "ratio",
    "error", "coherence", "phase"};
constexpr std::string_view other_parts[] = {"kraft", "gewicht", "druck", "spannung"};
constexpr std::string_view measure_words[] = {
    "rms",        "envelope",   "std",         "stdev",    "deviation", "variance", "log",
    "cumulative", "error",      "uncertainty", "wave",     "phase",     "flow",     "wind",
    "crack",      "settlement", "rain",        "rainfall", "particle",  "hold"};
constexpr std::string_view channel_words[] = {
    "north",  "south",     "east",      "west",    "nord",      "sued",       "sud",        "ost",
    "ouest",  "est",       "norte",     "sur",     "este",      "oeste",      "kuzey",      "guney",
    "dogu",   "bati",      "radial",    "lateral", "up",        "down",       "channel",    "channels",
    "kanal",  "canal",     "canale",    "sensor",  "component", "komponente", "composante", "componente",
    "comp",   "direction", "richtung",  "value",   "values",    "wert",       "werte",      "data",
    "daten",  "signal",    "amplitude", "motion",  "ground",    "boden",      "base",       "table",
    "shake",  "shaking",   "input",     "output",  "target",    "measured",   "filtered",   "corrected",
    "record", "recorded",  "motion",    "series",  "command",   "reference",  "feedback",   "achieved",
    "desired"};
constexpr std::string_view channel_parts[] = {"longit", "transv",   "trasv",   "vertic",
                                              "vertik", "horizont", "orizzont"};
constexpr std::string_view counting_words[] = {
    "index",   "sample", "samples", "no",    "nr",     "#",      "point",  "points", "row",  "id",
    "unnamed", "date",   "datum",   "count", "number", "nummer", "numero", "numara", "line", "zeile"};
constexpr std::string_view spectral_words[] = {"sa",
                                               "psa",
                                               "sv",
                                               "psv",
                                               "sd",
                                               "se",
                                               "sae",
                                               "tn",
                                               "pseudo",
                                               "fourier",
                                               "fft",
                                               "psd",
                                               "damping",
                                               "dampfung",
                                               "amortiguamiento",
                                               "amortissement",
                                               "smorzamento",
                                               "spectra",
                                               "スペクトル",
                                               "谱"};
constexpr std::string_view pseudo_words[] = {"pseudo", "damped", "uhs", "sdof", "スペクトル"};
constexpr std::string_view spectrum_parts[] = {"widmo", "spektar", "spektr", "스펙트럼", "طیف",   "譜",
                                               "谱",    "spectr",  "spektr", "spettr",   "φασμα", "спектр"};
constexpr std::string_view period_parts[] = {
    "okres", "period",  "periyo", "periyot", "schwingdauer", "schwingungsdauer", "περιοδο", "период", "周期",
    "freq",  "frecuen", "frekan", "frekven", "συχνοτητ",     "частот",           "周波数",  "频率"};
constexpr std::string_view history_words[] = {"history",       "histories",   "series",     "accelerogram",
                                              "accelerograms", "seismogram",  "matched",    "matching",
                                              "compatible",    "compatibile", "kompatibel", "angepasst"};
constexpr std::string_view history_parts[] = {"zeitverlauf"};
constexpr std::string_view factor_words[] = {
    "sf",          "factor",       "factors",       "multiplier",    "gain",         "calibration",
    "scale",       "scaling",      "faktor",        "facteur",       "fattore",      "multiplikator",
    "verstarkung", "kalibrierung", "skalierung",    "calibracion",   "calibrazione", "ganancia",
    "guadagno",    "escala",       "echelle",       "scala",         "katsayi",      "katsayisi",
    "carpan",      "olcek",        "amplification", "magnification", "kazanc"};
constexpr std::string_view factor_parts[] = {"faktor"};
constexpr std::string_view normalised_parts[] = {"normali", "normiert", "dimensionless"};
constexpr std::string_view peak_words[] = {"pga", "peak", "max", "maximum", "min", "minimum", "pgv", "pgd"};

bool has_whole(Vocabulary list, std::string_view word) {
  return std::ranges::find(list, word) != list.end();
}

bool has_part(Vocabulary list, std::string_view word) {
  return std::ranges::any_of(list, [&](auto part) { return word.find(part) != word.npos; });
}

/// Words that are of a topic as they stand, and parts that make every word with them one.
struct Entry {
  Topic topic;
  Vocabulary wholes = {}, parts = {};
};

constexpr Entry entries_of_topics[] = {{Topic::acceleration, acceleration_words, acceleration_parts},
                                       {Topic::acceleration_letter, acceleration_letters, {}},
                                       {Topic::velocity, velocity_words, velocity_parts},
                                       {Topic::displacement, displacement_words, displacement_parts},
                                       {Topic::time, full_times, full_time_parts},
                                       {Topic::time_letter, time_letters, {}},
                                       {Topic::second, second_words, {}},
                                       {Topic::angle, angle_words, angle_parts},
                                       {Topic::rotation, rotation_words, rotation_parts},
                                       {Topic::other, other_words, other_parts},
                                       {Topic::measure, measure_words, {}},
                                       {Topic::channel, channel_words, channel_parts},
                                       {Topic::counting, counting_words, {}},
                                       {Topic::spectrum, pseudo_words, spectrum_parts},
                                       {Topic::spectral_ordinate, spectral_words, spectrum_parts},
                                       {Topic::spectral_ordinate, {}, period_parts},
                                       {Topic::history, history_words, history_parts},
                                       {Topic::factor, factor_words, factor_parts},
                                       {Topic::normalised, {}, normalised_parts},
                                       {Topic::peak, peak_words, {}}};

/// Letters that stand for others: capitals of two bytes, accents, final forms.
constexpr std::pair<std::string_view, std::string_view> letters[] = {
    {"à", "a"},     {"á", "a"},     {"â", "a"},     {"ã", "a"},     {"ä", "a"},     {"å", "a"},
    {"À", "a"},     {"Á", "a"},     {"Â", "a"},     {"Ã", "a"},     {"Ä", "a"},     {"ç", "c"},
    {"Ç", "c"},     {"è", "e"},     {"é", "e"},     {"ê", "e"},     {"ë", "e"},     {"È", "e"},
    {"É", "e"},     {"Ê", "e"},     {"ğ", "g"},     {"Ğ", "g"},     {"ì", "i"},     {"í", "i"},
    {"î", "i"},     {"ï", "i"},     {"ı", "i"},     {"İ", "i"},     {"Í", "i"},     {"Î", "i"},
    {"ñ", "n"},     {"Ñ", "n"},     {"ò", "o"},     {"ó", "o"},     {"ô", "o"},     {"õ", "o"},
    {"ö", "o"},     {"Ó", "o"},     {"Ô", "o"},     {"Ö", "o"},     {"ş", "s"},     {"Ş", "s"},
    {"ß", "ss"},    {"ù", "u"},     {"ú", "u"},     {"û", "u"},     {"ü", "u"},     {"Ù", "u"},
    {"Ú", "u"},     {"Û", "u"},     {"Ü", "u"},     {"ά", "α"},     {"έ", "ε"},     {"ή", "η"},
    {"ί", "ι"},     {"ό", "ο"},     {"ύ", "υ"},     {"ώ", "ω"},     {"ς", "σ"},     {"Ά", "α"},
    {"Έ", "ε"},     {"Ή", "η"},     {"Ί", "ι"},     {"Ό", "ο"},     {"Ύ", "υ"},     {"Ώ", "ω"},
    {"Α", "α"},     {"Β", "β"},     {"Γ", "γ"},     {"Δ", "δ"},     {"Ε", "ε"},     {"Ζ", "ζ"},
    {"Η", "η"},     {"Θ", "θ"},     {"Ι", "ι"},     {"Κ", "κ"},     {"Λ", "λ"},     {"Μ", "μ"},
    {"Ν", "ν"},     {"Ξ", "ξ"},     {"Ο", "ο"},     {"Π", "π"},     {"Ρ", "ρ"},     {"Σ", "σ"},
    {"Τ", "τ"},     {"Υ", "υ"},     {"Φ", "φ"},     {"Χ", "χ"},     {"Ψ", "ψ"},     {"Ω", "ω"},
    {"А", "а"},     {"Б", "б"},     {"В", "в"},     {"Г", "г"},     {"Д", "д"},     {"Е", "е"},
    {"Ж", "ж"},     {"З", "з"},     {"И", "и"},     {"К", "к"},     {"Л", "л"},     {"М", "м"},
    {"Н", "н"},     {"О", "о"},     {"П", "п"},     {"Р", "р"},     {"С", "с"},     {"Т", "т"},
    {"У", "у"},     {"Ф", "ф"},     {"Х", "х"},     {"Ц", "ц"},     {"Ч", "ч"},     {"Щ", "щ"},
    {"\u0300", ""}, {"\u0301", ""}, {"\u0302", ""}, {"\u0303", ""}, {"\u0307", ""}, {"\u0308", ""},
    {"\u0327", ""}};

}  // namespace

std::string folded(std::string_view text) {
  const std::string small = lower(text);
  std::string plain;
  for (std::string_view rest = small; !rest.empty();) {
    const auto starts = [&](const auto& letter) { return rest.starts_with(letter.first); };
    const auto letter = std::ranges::find_if(letters, starts);
    const bool known = letter != std::end(letters);
    plain += known ? letter->second : rest.substr(0, 1);
    rest.remove_prefix(known ? letter->first.size() : 1);
  }
  return plain;
}

std::vector<std::string_view> words_in(std::string_view plain) {
  return words(plain, ",.:;_-/()[]{}'\"|=+%<>*0123456789");
}

bool is_of(std::string_view word, Topic topic) {
  return std::ranges::any_of(entries_of_topics, [&](const Entry& entry) {
    return entry.topic == topic && (has_whole(entry.wholes, word) || has_part(entry.parts, word));
  });
}

bool any_of_topic(const std::vector<std::string_view>& name, Topic topic) {
  return std::ranges::any_of(name, [&](auto word) { return is_of(word, topic); });
}

bool speaks_of(std::string_view text, Topic topic) {
  const std::string plain = folded(text);
  return any_of_topic(words_in(plain), topic);
}

}  // namespace rockstack::records
