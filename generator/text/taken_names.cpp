#include "text/taken_names.hpp"

#include <set>
#include <sstream>
#include <string>

namespace treeline {
namespace {

// clang-format off
constexpr const char* kKeywords =
    "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t "
    "char32_t char8_t class co_await co_return co_yield compl concept const const_cast consteval "
    "constexpr constinit continue decltype default delete do double dynamic_cast else enum "
    "explicit export extern false float for friend goto if inline int long mutable namespace new "
    "noexcept not not_eq nullptr operator or or_eq private protected public register "
    "reinterpret_cast requires restrict return short signed sizeof static static_assert static_cast struct "
    "switch template this thread_local throw true try typedef typeid typename union unsigned "
    "using virtual void volatile wchar_t while xor xor_eq ";

/// Macros of the headers of C and of <math.h> and <unistd.h> as they are usually found; those of
/// <inttypes.h> and <stdint.h> are told by their form.
constexpr const char* kMacros =
    "BUFSIZ CHAR_BIT CHAR_MAX CHAR_MIN CLOCKS_PER_SEC CMPLX CMPLXF CMPLXL DBL_DECIMAL_DIG DBL_DIG "
    "DBL_EPSILON DBL_HAS_SUBNORM DBL_MANT_DIG DBL_MAX DBL_MAX_10_EXP DBL_MAX_EXP DBL_MIN "
    "DBL_MIN_10_EXP DBL_MIN_EXP DBL_TRUE_MIN DECIMAL_DIG DOMAIN E2BIG EACCES EADDRINUSE "
    "EADDRNOTAVAIL EADV EAFNOSUPPORT EAGAIN EALREADY EBADE EBADF EBADFD EBADMSG EBADR EBADRQC "
    "EBADSLT EBFONT EBUSY ECANCELED ECHILD ECHRNG ECOMM ECONNABORTED ECONNREFUSED ECONNRESET "
    "EDEADLK EDEADLOCK EDESTADDRREQ EDOM EDOTDOT EDQUOT EEXIST EFAULT EFBIG EHOSTDOWN "
    "EHOSTUNREACH EHWPOISON EIDRM EILSEQ EINPROGRESS EINTR EINVAL EIO EISCONN EISDIR EISNAM "
    "EKEYEXPIRED EKEYREJECTED EKEYREVOKED EL2HLT EL2NSYNC EL3HLT EL3RST ELIBACC ELIBBAD ELIBEXEC "
    "ELIBMAX ELIBSCN ELNRNG ELOOP EMEDIUMTYPE EMFILE EMLINK EMSGSIZE EMULTIHOP ENAMETOOLONG "
    "ENAVAIL ENETDOWN ENETRESET ENETUNREACH ENFILE ENOANO ENOBUFS ENOCSI ENODATA ENODEV ENOENT "
    "ENOEXEC ENOKEY ENOLCK ENOLINK ENOMEDIUM ENOMEM ENOMSG ENONET ENOPKG ENOPROTOOPT ENOSPC ENOSR "
    "ENOSTR ENOSYS ENOTBLK ENOTCONN ENOTDIR ENOTEMPTY ENOTNAM ENOTRECOVERABLE ENOTSOCK ENOTSUP "
    "ENOTTY ENOTUNIQ ENXIO EOF EOPNOTSUPP EOVERFLOW EOWNERDEAD EPERM EPFNOSUPPORT EPIPE EPROTO "
    "EPROTONOSUPPORT EPROTOTYPE ERANGE EREMCHG EREMOTE EREMOTEIO ERESTART ERFKILL EROFS ESHUTDOWN "
    "ESOCKTNOSUPPORT ESPIPE ESRCH ESRMNT ESTALE ESTRPIPE ETIME ETIMEDOUT ETOOMANYREFS ETXTBSY "
    "EUCLEAN EUNATCH EUSERS EWOULDBLOCK EXDEV EXFULL EXIT_FAILURE EXIT_SUCCESS FE_ALL_EXCEPT "
    "FE_DFL_ENV FE_DIVBYZERO FE_DOWNWARD FE_INEXACT FE_INVALID FE_OVERFLOW FE_TONEAREST "
    "FE_TOWARDZERO FE_UNDERFLOW FE_UPWARD FILENAME_MAX FLT_DECIMAL_DIG FLT_DIG FLT_EPSILON "
    "FLT_EVAL_METHOD FLT_HAS_SUBNORM FLT_MANT_DIG FLT_MAX FLT_MAX_10_EXP FLT_MAX_EXP FLT_MIN "
    "FLT_MIN_10_EXP FLT_MIN_EXP FLT_RADIX FLT_ROUNDS FLT_TRUE_MIN FOPEN_MAX FP_ILOGB0 FP_ILOGBNAN "
    "FP_INFINITE FP_NAN FP_NORMAL FP_SUBNORMAL FP_ZERO F_OK HUGE HUGE_VAL HUGE_VALF HUGE_VALL I "
    "INFINITY IOV_MAX LDBL_DECIMAL_DIG LDBL_DIG LDBL_EPSILON LDBL_HAS_SUBNORM LDBL_MANT_DIG "
    "LDBL_MAX LDBL_MAX_10_EXP LDBL_MAX_EXP LDBL_MIN LDBL_MIN_10_EXP LDBL_MIN_EXP LDBL_TRUE_MIN "
    "LINE_MAX LLONG_MAX LLONG_MIN LONG_MAX LONG_MIN L_INCR L_SET L_XTND L_tmpnam MAP_FAILED "
    "MATH_ERREXCEPT MATH_ERRNO MAXFLOAT MB_CUR_MAX MB_LEN_MAX M_1_PI M_2_PI M_2_SQRTPI M_E M_LN10 "
    "M_1_PIl M_2_PIl M_2_SQRTPIl M_El M_LN10l M_LN2l M_LOG10El M_LOG2El M_PIl M_PI_2l M_PI_4l "
    "M_SQRT1_2l M_SQRT2l "
    "M_LN2 M_LOG10E M_LOG2E M_PI M_PI_2 M_PI_4 M_SQRT1_2 M_SQRT2 NAN NULL OVERFLOW PATH_MAX PLOSS "
    "PTRDIFF_MAX PTRDIFF_MIN RAND_MAX R_OK SCHAR_MAX SCHAR_MIN SEEK_CUR SEEK_END SEEK_SET "
    "SHRT_MAX SHRT_MIN SIGABRT SIGALRM SIGBUS SIGCHLD SIGCLD SIGCONT SIGFPE SIGHUP SIGILL SIGINT "
    "SIGIO SIGIOT SIGKILL SIGPIPE SIGPOLL SIGPROF SIGPWR SIGQUIT SIGRTMAX SIGRTMIN SIGSEGV "
    "SIGSTKFLT SIGSTOP SIGSYS SIGTERM SIGTRAP SIGTSTP SIGTTIN SIGTTOU SIGURG SIGUSR1 SIGUSR2 "
    "SIGVTALRM SIGWINCH SIGXCPU SIGXFSZ SIG_ATOMIC_MAX SIG_ATOMIC_MIN SIG_DFL SIG_ERR SIG_IGN "
    "SING SIZE_MAX SNAN SNANF SSIZE_MAX TIME_UTC TLOSS TMP_MAX UCHAR_MAX ULLONG_MAX ULONG_MAX "
    "UNDERFLOW USHRT_MAX WCHAR_MAX WCHAR_MIN WEOF WINT_MAX WINT_MIN W_OK X_OK alloca assert "
    "complex errno fpclassify i386 isalnum isalpha isblank iscntrl isdigit isfinite isgraph "
    "isgreater isgreaterequal isinf isless islessequal islessgreater islower isnan isnormal "
    "isprint ispunct isspace isunordered isupper isxdigit linux major makedev math_errhandling "
    "minor offsetof sa_handler setjmp si_pid si_uid si_value signbit st_atime st_ctime st_mtime "
    "stderr stdin stdout strtoq unix va_arg va_copy va_end va_start ";

/// Functions, objects and types that those headers declare at global scope, and what emitted code
/// calls its number type.
constexpr const char* kGlobals =
    "Real main posix std "
    "FILE a64l abort abs accept access acct acos acosf acosh acoshf acoshl acosl alarm "
    "aligned_alloc arc4random arc4random_buf arc4random_uniform asctime asin asinf asinh asinhf "
    "asinhl asinl at_quick_exit atan atan2 atan2f atan2l atanf atanh atanhf atanhl atanl atexit "
    "atof atoi atol atoll bcmp bcopy bind brk bsearch btowc bzero c16rtomb c32rtomb calloc cbrt "
    "cbrtf cbrtl ceil ceilf ceill chdir chmod chown chroot clearenv clearerr clock "
    "clock_getcpuclockid clock_getres clock_gettime clock_nanosleep clock_settime clock_t close "
    "closefrom cmsghdr confstr connect copysign copysignf copysignl cos cosf cosh coshf coshl "
    "cosl creat crypt ctermid ctime daemon daylight difftime div div_t double_t dprintf drem "
    "dremf dreml dup dup2 duplocale dysize ecvt endusershell erf erfc erfcf erfcl erff erfl execl "
    "execle execlp execv execve execvp exit exp exp2 exp2f exp2l expf expl explicit_bzero expm1 "
    "expm1f expm1l fabs fabsf fabsl faccessat fchdir fchmod fchmodat fchown fchownat fclose fcntl "
    "fcvt fd_mask fd_set fdatasync fdim fdimf fdiml fdopen feclearexcept fegetenv fegetexceptflag "
    "fegetround feholdexcept fenv_t feof feraiseexcept ferror fesetenv fesetexceptflag fesetround "
    "fetestexcept feupdateenv fexcept_t fexecve fflush ffs ffsl ffsll fgetc fgetpos fgets fgetwc "
    "fgetws fileno finite finitef finitel float_t flock flockfile floor floorf floorl fma fmaf "
    "fmal fmax fmaxf fmaxl fmemopen fmin fminf fminl fmod fmodf fmodl fopen fork fpathconf fpos_t "
    "fprintf fputc fputs fputwc fputws fread free freelocale freopen frexp frexpf frexpl fscanf "
    "fseek fseeko fsetpos fstat fstatat fsync ftell ftello ftruncate ftrylockfile funlockfile "
    "futimens fwide fwprintf fwrite fwscanf gamma gammaf gammal gcvt getc getchar getcwd getdelim "
    "getdomainname getdtablesize getegid getentropy getenv geteuid getgid getgroups gethostid "
    "gethostname getline getloadavg getlogin getopt getpagesize getpass getpeername getpgid "
    "getpgrp getpid getppid getsid getsockname getsockopt getsubopt getuid getusershell getw "
    "getwc getwchar getwd gmtime gsignal hypot hypotf hypotl ilogb ilogbf ilogbl imaxabs imaxdiv "
    "imaxdiv_t index initstate int16_t int32_t int64_t int8_t int_fast16_t int_fast32_t "
    "int_fast64_t int_fast8_t int_least16_t int_least32_t int_least64_t int_least8_t intmax_t "
    "intptr_t iovec isascii isatty isfdtype isinff isinfl isnanf isnanl iswalnum iswalpha "
    "iswblank iswcntrl iswctype iswdigit iswgraph iswlower iswprint iswpunct iswspace iswupper "
    "iswxdigit itimerspec j0 j0f j0l j1 j1f j1l jmp_buf jn jnf jnl kill killpg l64a labs lchmod "
    "lchown lconv ldexp ldexpf ldexpl ldiv ldiv_t lgamma lgammaf lgammal linger link linkat "
    "listen llabs lldiv lldiv_t llrint llrintf llrintl llround llroundf llroundl localeconv "
    "localtime lockf log log10 log10f log10l log1p log1pf log1pl log2 log2f log2l logb logbf "
    "logbl logf logl longjmp lrint lrintf lrintl lround lroundf lroundl lseek lstat madvise "
    "malloc max_align_t mblen mbrlen mbrtoc16 mbrtoc32 mbrtowc mbsinit mbsnrtowcs mbsrtowcs "
    "mbstate_t mbstowcs mbtowc memccpy memchr memcmp memcpy memmove memset mincore mkdir mkdirat "
    "mkdtemp mkfifo mkfifoat mknod mknodat mkstemp mkstemps mktemp mktime mlock mlockall mmap "
    "modf modff modfl mprotect msghdr msync munlock munlockall munmap nan nanf nanl nanosleep "
    "nearbyint nearbyintf nearbyintl newlocale nextafter nextafterf nextafterl nexttoward "
    "nexttowardf nexttowardl nice on_exit open open_memstream open_wmemstream openat optarg "
    "opterr optind optopt osockaddr pathconf pause pclose perror pipe popen posix_fadvise "
    "posix_fallocate posix_madvise posix_memalign pow powf powl pread printf profil pselect "
    "psiginfo psignal ptrdiff_t putc putchar putenv puts putw putwc putwchar pwrite qecvt qfcvt "
    "qgcvt qsort quick_exit raise rand random random_data read readlink readlinkat realloc "
    "reallocarray realpath recv recvfrom recvmsg remainder remainderf remainderl remove remquo "
    "remquof remquol rename renameat revoke rewind rindex rint rintf rintl rmdir round roundf "
    "roundl rpmatch sbrk scalb scalbf scalbl scalbln scalblnf scalblnl scalbn scalbnf scalbnl "
    "scanf select send sendmsg sendto setbuf setbuffer setdomainname setegid setenv seteuid "
    "setgid sethostid sethostname setlinebuf setlocale setlogin setpgid setpgrp setregid setreuid "
    "setsid setsockopt setstate setuid setusershell setvbuf shm_open shm_unlink shutdown "
    "sig_atomic_t sigaction sigaddset sigaltstack sigblock sigcontext sigdelset sigemptyset "
    "sigevent sigfillset siggetmask siginterrupt sigismember sigjmp_buf siglongjmp signal signgam "
    "significand significandf significandl sigpending sigprocmask sigqueue sigreturn sigsetmask "
    "sigstack sigsuspend sigtimedwait sigval sigwait sigwaitinfo sin sinf sinh sinhf sinhl sinl "
    "size_t sleep snprintf sockaddr sockaddr_storage sockatmark socket socketpair sprintf sqrt "
    "sqrtf sqrtl srand srandom sscanf ssignal stat stpcpy stpncpy strcasecmp strcat strchr strcmp "
    "strcoll strcpy strcspn strdup strerror strftime strlen strncasecmp strncat strncmp strncpy "
    "strndup strnlen strpbrk strrchr strsep strsignal strspn strstr strtod strtof strtoimax "
    "strtok strtol strtold strtoll strtoul strtoull strtoumax strtouq strxfrm swprintf swscanf "
    "symlink symlinkat sync syscall sysconf system tan tanf tanh tanhf tanhl tanl tcgetpgrp "
    "tcsetpgrp tempnam tgamma tgammaf tgammal time time_t timegm timelocal timer_create "
    "timer_delete timer_getoverrun timer_gettime timer_settime timespec timespec_get timeval "
    "timezone tm tmpfile tmpnam toascii tolower toupper towctrans towlower towupper trunc "
    "truncate truncf truncl ttyname ttyslot tzname tzset u_char u_int u_long u_short ualarm uint "
    "uint16_t uint32_t uint64_t uint8_t uint_fast16_t uint_fast32_t uint_fast64_t uint_fast8_t "
    "uint_least16_t uint_least32_t uint_least64_t uint_least8_t uintmax_t uintptr_t ulong umask "
    "ungetc ungetwc unlink unlinkat unsetenv uselocale ushort usleep utimensat va_list valloc "
    "vdprintf vfork vfprintf vfscanf vfwprintf vfwscanf vhangup vprintf vscanf vsnprintf vsprintf "
    "vsscanf vswprintf vswscanf vwprintf vwscanf wcpcpy wcpncpy wcrtomb wcscasecmp wcscat wcschr "
    "wcscmp wcscoll wcscpy wcscspn wcsdup wcsftime wcslen wcsncasecmp wcsncat wcsncmp wcsncpy "
    "wcsnlen wcsnrtombs wcspbrk wcsrchr wcsrtombs wcsspn wcsstr wcstod wcstof wcstoimax wcstok "
    "wcstol wcstold wcstoll wcstombs wcstoul wcstoull wcstoumax wcsxfrm wctob wctomb wctrans "
    "wctrans_t wctype wctype_t wint_t wmemchr wmemcmp wmemcpy wmemmove wmemset wprintf write "
    "wscanf y0 y0f y0l y1 y1f y1l yn ynf ynl ";
// clang-format on

std::set<std::string, std::less<>> list_names() {
  std::set<std::string, std::less<>> names;
  for (const char* list : {kKeywords, kMacros, kGlobals}) {
    std::istringstream words(list);
    for (std::string word; words >> word;) names.insert(word);
  }
  return names;
}

/// `PRId64`, `SCNu8`, `INT_LEAST8_MAX`, `UINT64_C`, `LC_ALL`.
bool is_of_macro_family(std::string_view name) {
  if (name.starts_with("PRI") || name.starts_with("SCN")) {
    return name.size() > 4 && std::string_view("bBdiouxX").find(name[3]) != std::string_view::npos;
  }
  const bool integer = name.starts_with("INT") || name.starts_with("UINT");
  const bool limit = name.ends_with("_MAX") || name.ends_with("_MIN") || name.ends_with("_C");
  return (integer && limit) || name.starts_with("LC_");
}

}  // namespace

bool is_taken_name(std::string_view name) {
  static const auto names = list_names();
  return names.contains(name) || is_of_macro_family(name);
}

}  // namespace treeline
