// The main function of programs that are only linked (pal_links_alone).
int main() {}
