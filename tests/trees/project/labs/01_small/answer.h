constexpr int answer = 42;
