// Nothing here fails by number.
#ifndef PAGE_ERRNO_H
#define PAGE_ERRNO_H

#define errno 0

#endif
