// A player for carom's arena, carom-arena/1: it pots the easiest ball, aimed at the ghost ball.
// g++ -O2 -std=c++20 -o player player.cpp && carom arena check exec:./player
#include <algorithm>
#include <complex>
#include <cstring>
#include <iostream>
#include <map>
#include <vector>
using std::string;
using Point = std::complex<double>;  // x + iy, m
struct Json {  // a value of a message; true, false and null are texts
  std::map<string, Json> fields;
  std::vector<Json> items;
  string text;
  double number;
  const Json& operator[](const string& key) const { return fields.at(key); }
  bool has(const string& word) const { for (auto& item : items) if (item.text == word) return true; return false; }
  Point point() const { return {items.at(0).number, items.at(1).number}; }
};
Json read(const char*& p) {
  Json value;
  auto skip = [&p](int n) { p += n, p += std::strspn(p, " ,:"); };
  skip(0);
  if (*p == '{') {
    for (skip(1); *p != '}'; skip(0)) { string key = read(p).text; value.fields[key] = read(p); }
  } else if (*p == '[') {
    for (skip(1); *p != ']'; skip(0)) value.items.push_back(read(p));
  } else if (*p == '"') {
    while (*++p != '"') value.text += *p == '\\' ? *++p : *p;
  } else {
    while (*p && !std::strchr(" ,:]}", *p)) value.text += *p++;
    value.number = std::atof(value.text.c_str());
    --p;  // at the last character, as for the others
  }
  ++p;
  return value;
}
// Whether no ball but those two is nearer than gap to the way from start to end.
bool is_clear(Point start, Point end, const auto& balls, const string& one, const string& other, double gap) {
  return std::none_of(balls.begin(), balls.end(), [&](auto& ball) {
    Point way = end - start, to = ball.second - start;
    double along = std::clamp(std::real(to * std::conj(way)) / std::max(std::norm(way), 1e-12), 0.0, 1.0);
    return ball.first != one && ball.first != other && std::abs(to - along * way) < gap;
  });
}
// The easiest pot; without one a soft hit of a ball that is on.
void shot(const Json& match, const Json& request, size_t attempt) {
  const string cue_id = request["cue_ball"].text;
  const Json &on = request["on"], &calls = request["calls"];
  const double radius = match["balls"][cue_id]["radius"].number;
  const bool opening = request["opening"].text == "true", in_hand = request["in_hand"].text != "null";
  std::map<string, Point> balls;
  for (auto& [id, place] : request["balls"].fields) balls[id] = place.point();
  std::vector<Point> places(in_hand ? 0 : 1, balls[cue_id]);  // where it lies, or free points of its region
  for (int k = 0; in_hand && k < 81; ++k) {
    const auto& box = request["region"]["bounds"].items;
    Point size = box[1].point() - box[0].point(), middle = box[1].point() - size.real() / 2;  // of its upper line
    Point at = middle + Point(size.real() * (k % 9 - 4) / 12, -size.imag() * (k / 9 + 1) / 20);
    if (is_clear(at, at, balls, cue_id, cue_id, 2.05 * radius)) places.push_back(at);
  }
  std::vector<string> targets;
  for (auto& [id, place] : balls) if (id != cue_id && (on.items.empty() || on.has(id))) targets.push_back(id);
  Point cue = places.at(attempt % places.size()), aim = balls[targets.at(0)];
  string target = targets[0], pocket, call;
  double best = -1, speed = opening ? 8 : 2;
  if (opening || attempt > 0) places.clear();
  for (Point from : places) for (auto& id : targets) for (auto& hole : match["geometry"]["pockets"].items) {
    Point into = hole["center"].point(), way = into - balls[id];
    Point ghost = balls[id] - way * (2 * radius / std::abs(way)), reach = ghost - from;
    double far = std::abs(way), near = std::abs(reach), full = std::real(reach * std::conj(way)) / (near * far);
    double score = full / (0.3 + far) / (0.5 + near);
    if (full < 0.3 || score <= best || !is_clear(from, ghost, balls, cue_id, id, 2 * radius) ||
        !is_clear(balls[id], into, balls, cue_id, id, 2 * radius)) continue;
    best = score, cue = from, aim = ghost, target = id, pocket = hole["name"].text;
    speed = std::min(1 + 0.7 * (near + far) / full, 10.0);
  }
  std::cout << R"("type": "play", "strike": {"speed": )" << speed << R"(, "azimuth": )" << std::arg(aim - cue) << "}";
  if (in_hand) std::cout << R"(, "cue_ball": [)" << cue.real() << ", " << cue.imag() << "]";
  if (calls.has("on")) call = "on\", \"ball\": \"" + target;
  else if (calls.has("pocket") && best > 0) call = "pocket\", \"ball\": \"" + target + "\", \"into\": \"" + pocket;
  else if (!calls.has("nothing")) call = "safety";
  if (!call.empty()) std::cout << R"(, "call": {"kind": ")" << call << "\"}";
}
int main() {
  Json match, request; size_t attempt = 0;
  for (string line; std::getline(std::cin, line);) {
    const char* p = line.c_str(); const Json message = read(p);
    const string kind = message["type"].text;
    std::cout.precision(17);
    attempt = kind == "refused" ? attempt + 1 : 0;
    if (kind == "hello") std::cout << R"({"type": "hello", "name": "ghost ball", "version": "1"})" << std::endl;
    if (kind == "match") match = message, std::cout << R"({"type": "ready"})" << std::endl;
    if (kind == "request") request = message;
    if (kind != "request" && (kind != "refused" || message["id"].number != request["id"].number)) continue;
    std::cout << "{\"id\": " << request["id"].number << ", ";
    if (request["kind"].text == "shot") shot(match, request, attempt);
    else std::cout << R"("type": "choose", "choice": ")" << request["choices"].items[0].text << '"';
    std::cout << "}" << std::endl;
  }
}
