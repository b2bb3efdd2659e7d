// cplusplus.cc - much of C++'s language and library in one program; it prints the same wherever it runs.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <locale>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <typeinfo>
#include <unordered_map>
#include <valarray>
#include <variant>
#include <vector>

namespace
{
struct told {
    const char *name;
    explicit told(const char *n) : name(n) { std::cout << "begins: " << name << "\n"; }
    ~told() { std::cout << "ends: " << name << "\n"; }
};

told global("a global");
thread_local int plain = 5;
thread_local std::string text("of a thread");

struct shape {
    virtual ~shape() = default;
    virtual double area() const = 0;
};
struct square : shape {
    double side;
    explicit square(double s) : side(s) {}
    double area() const override { return side * side; }
};
struct other : shape {
    double area() const override { return 0; }
};

int calls()
{
    thread_local int count = 0;
    return ++count;
}

told &local_static()
{
    static told once("a local static");
    return once;
}

void at_exit()
{
    std::cout << "atexit\n";
}

int thrower(int depth)
{
    told here("a frame");
    if (depth == 0)
        throw std::runtime_error("from below");
    return thrower(depth - 1) + 1;
}

template <typename T> T sum(const std::vector<T> &v)
{
    return std::accumulate(v.begin(), v.end(), T());
}

void exceptions()
{
    try {
        thrower(2);
    } catch (const std::exception &e) {
        std::cout << "caught " << e.what() << "\n";
    }
    try {
        try {
            throw 7;
        } catch (int i) {
            std::cout << "again " << i << "\n";
            throw;
        }
    } catch (...) {
        std::cout << "the rest\n";
    }
    try {
        std::vector<int>(3).at(5) = 1;
    } catch (const std::out_of_range &e) {
        std::cout << e.what() << "\n";
    }
    try {
        square s(1);
        shape &of = s;
        dynamic_cast<other &>(of).area();
    } catch (const std::bad_cast &e) {
        std::cout << e.what() << "\n";
    }
    try {
        std::vector<char> much(std::size_t(1) << 46);
    } catch (const std::bad_alloc &e) {
        std::cout << e.what() << "\n";
    }
}

void containers()
{
    std::map<std::string, int> m{{"one", 1}, {"two", 2}};
    m["three"] = 3;
    std::unordered_map<std::string, double> u;
    for (int i = 0; i < 6; i++)
        u["k" + std::to_string(i)] = i * 1.25;
    for (const auto &x : m)
        std::cout << x.first << "=" << x.second << " ";
    for (const auto &x : u)
        std::cout << x.first << "=" << x.second << " ";
    std::vector<double> v(10);
    std::iota(v.begin(), v.end(), 0.5);
    std::sort(v.begin(), v.end(), std::greater<double>());
    std::cout << v.front() << " " << sum(v) << " " << std::setprecision(12)
              << sum(std::vector<float>(9, 0.1f)) << "\n";
    std::unique_ptr<shape> s(new square(3));
    std::shared_ptr<shape> t = std::make_shared<other>(), t2 = t;
    std::function<double(double)> twice = [&](double x) { return 2 * x * s->area(); };
    std::cout << s->area() << " " << twice(2) << " " << t.use_count() << " " << typeid(*s).name() << "\n";
    double read;
    std::string_view digits = "2.5e3";
    std::from_chars(digits.begin(), digits.end(), read);
    std::valarray<double> w{1, 2, 3};
    std::variant<int, std::string> any = "text";
    std::cout << read << " " << (w * 2.0).sum() << " " << std::get<std::string>(any) << "\n";
    std::mt19937 g(42);
    std::normal_distribution<double> d;
    std::cout << g() << " " << std::fixed << std::setprecision(9) << d(g) << "\n";
}

void streams()
{
    {
        std::ofstream out("cplusplus.txt");
        out << "line " << 42 << "\n" << std::hex << 255 << " 3.5\n";
    }
    std::ifstream in("cplusplus.txt");
    std::string word;
    int n;
    double x;
    in >> word >> n >> std::hex >> n >> x;
    std::cout << word << n << " " << x << "\n";
    std::stringstream s("1 2 3 x");
    int total = 0, value;
    while (s >> value)
        total += value;
    std::cout << total << " " << s.eof() << s.fail() << "\n";
    std::string line;
    std::getline(std::cin, line);
    std::cout << "read: " << line << "\n";
    try {
        std::locale l("xx_YY.UTF-8");
    } catch (const std::runtime_error &) {
        std::cout << "one locale\n";
    }
    std::cout << std::locale("").name() << " " << std::put_time(std::localtime(new std::time_t(0)), "%Y")
              << "\n";
}

void one_thread()
{
    std::once_flag flag;
    std::mutex mutex;
    for (int i = 0; i < 3; i++)
        std::call_once(flag, [] { std::cout << "once\n"; });
    std::lock_guard<std::mutex> held(mutex);
    plain++;
    text += "!";
    calls();
    auto start = std::chrono::steady_clock::now();
    std::cout << plain << " " << text << " " << calls() << " "
              << (std::chrono::steady_clock::now() >= start ? "time passes" : "it does not") << "\n";
}
__attribute__((noinline)) void fails(const std::string &text)
{
    throw std::logic_error(text);
}
} // namespace

int main(int argc, char **argv)
{
    std::atexit(at_exit);
    local_static();
    exceptions();
    containers();
    streams();
    one_thread();
    if (argc > 1)
        fails(argv[1]);
    return 0;
}
